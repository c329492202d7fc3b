// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <thread>
#include <vector>

#include "solver/base/loops.hpp"

namespace corpuscle::parallel {

/// Which thread begins with which tasks: those that lie side by side, so that what one leaves in a
/// core's cache is there for its neighbours, and for the next loop over the same tasks. What comes
/// out of tasks does not depend on it.
class TaskShares {
public:
    /// Tasks in runs of like weight along a line, one for each of the threads() that there are now.
    /// @param task_at  of a place on the line, 0..places-1; NONE: no task
    /// @param weight   of a task, its time in any unit
    template <class TaskAt, class Weight>
    void deal(std::size_t places, TaskAt&& task_at, Weight&& weight) {
        const auto members = static_cast<std::size_t>(threads());
        double all = 0.0;
        std::size_t tasks = 0;
        for (std::size_t p = 0; p < places; ++p)
            if (const std::size_t task = task_at(p); task != NONE) {
                all += weight(task);
                ++tasks;
            }
        member_.resize(tasks);
        start_.assign(members + 1, 0);
        double so_far = 0.0;
        for (std::size_t p = 0; p < places; ++p) {
            const std::size_t task = task_at(p);
            if (task == NONE) continue;
            const double own = weight(task), middle = so_far + 0.5 * own;
            so_far += own;
            const double at = all > 0.0 ? middle / all * static_cast<double>(members) : 0.0;
            const std::size_t member = std::min(members - 1, static_cast<std::size_t>(at));
            member_[task] = static_cast<std::uint32_t>(member);
            ++start_[member + 1];
        }
        for (std::size_t m = 0; m < members; ++m) start_[m + 1] += start_[m];
        list_.resize(tasks);
        next_.assign(start_.begin(), start_.end() - 1);
        for (std::size_t task = 0; task < tasks; ++task)
            list_[next_[member_[task]]++] = static_cast<std::uint32_t>(task);
    }
    static constexpr auto NONE = static_cast<std::size_t>(-1);

    [[nodiscard]] std::size_t tasks() const { return list_.size(); }
    [[nodiscard]] int members() const { return static_cast<int>(start_.size()) - 1; }
    /// A member's tasks, ascending.
    [[nodiscard]] std::span<const std::uint32_t> of(int member) const {
        const auto m = static_cast<std::size_t>(member);
        return std::span(list_).subspan(start_[m], start_[m + 1] - start_[m]);
    }

private:
    std::vector<std::uint32_t> member_;              ///< by task
    std::vector<std::size_t> start_{0, 0}, next_{};  ///< in list_, by member
    std::vector<std::uint32_t> list_;
};

/// Tasks in an order, each of which waits for some before it, and for no others.
class Tasks {
public:
    /// body(task) for all tasks of the shares, in one call of the threads. before(task, visit):
    /// visit(those that it waits for), all of them below it. Shares dealt for other threads than
    /// there are: on one thread.
    template <class Before, class Body>
    void run(const TaskShares& shares, Before&& before, Body&& body, bool is_worth_it,
             const Cut::Where& where) {
        if (is_worth_it && !Call::is_under_way() && shares.tasks() > 0)
            return share_out(shares, before, body, where);
        for (std::size_t task = 0; task < shares.tasks(); ++task) body(task);
    }

private:
    template <class Before, class Body>
    void share_out(const TaskShares& shares, Before& before, Body& body, const Cut::Where& where) {
        const std::size_t tasks = shares.tasks();
        if (tasks > room_) {
            done_ = std::make_unique<std::atomic<std::uint32_t>[]>(tasks);
            room_ = tasks;
            round_ = 0;
        }
        const std::uint32_t round = ++round_;
        LoopObserver* const observer = observer_here();
        if (observer != nullptr) observer->begin(where);
        const auto do_one = [&](std::size_t task) {
            before(task, [&](std::size_t other) {
                wait_for(other, round);
                if (observer != nullptr) observer->waits_for(other);
            });
            body(task);
            done_[task].store(round, std::memory_order_release);
            if (observer != nullptr) observer->end_chunk();
        };
        call_threads(
            shares.members() == threads(),
            [&](Team& team, int member) {
                team.go_through_lists(
                    member, [&](int whose) { return shares.of(whose).size(); },
                    [&](int whose, std::size_t k) { do_one(shares.of(whose)[k]); });
            },
            [&] {
                for (std::size_t task = 0; task < tasks; ++task) do_one(task);
            });
        if (observer != nullptr) observer->end();
    }

    /// The first task that is not done waits for none: whose it is takes his tasks in their order, so
    /// he or another is at work on it, or he comes to it.
    void wait_for(std::size_t task, std::uint32_t round) const {
        constexpr int SPINS = 1000;  // about a microsecond; then others may need this core
        for (int i = 0; done_[task].load(std::memory_order_acquire) != round; ++i)
            if (i >= SPINS) std::this_thread::yield();
    }

    std::unique_ptr<std::atomic<std::uint32_t>[]> done_;  ///< by task: in which round last
    std::size_t room_ = 0;
    std::uint32_t round_ = 0;
};

}  // namespace corpuscle::parallel
