// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <thread>

#include "solver/base/parallel.hpp"

namespace corpuscle::parallel {

/// Tasks in an order, each of which waits for some before it, and for no others.
class Tasks {
public:
    /// body(task) for 0..tasks in one call of the threads. before(task, visit): visit(those that it
    /// waits for), all of them below it.
    template <class Before, class Body>
    void run(std::size_t tasks, Before&& before, Body&& body, bool is_worth_it,
             const Cut::Where& where) {
        const bool is_shared = threads() > 1 || LoopObserver::running != nullptr;
        if (is_worth_it && is_shared && !is_within_loop())
            return share_out(tasks, before, body, where);
        for (std::size_t task = 0; task < tasks; ++task) body(task);
    }

private:
    [[nodiscard]] static bool is_within_loop() {
#ifdef _OPENMP
        return omp_in_parallel() != 0;
#else
        return true;
#endif
    }

    template <class Before, class Body>
    void share_out(std::size_t tasks, Before& before, Body& body, const Cut::Where& where) {
        if (tasks > room_) {
            done_ = std::make_unique<std::atomic<std::uint32_t>[]>(tasks);
            room_ = tasks;
            round_ = 0;
        }
        const std::uint32_t round = ++round_;
        LoopObserver* const observer = observer_here();
        if (observer != nullptr) observer->begin(where);
        std::atomic<std::size_t> next{0};
#ifdef _OPENMP
#pragma omp parallel
#endif
        for (std::size_t task; (task = next.fetch_add(1, std::memory_order_relaxed)) < tasks;) {
            before(task, [&](std::size_t other) {
                wait_for(other, round);
                if (observer != nullptr) observer->waits_for(other);
            });
            body(task);
            done_[task].store(round, std::memory_order_release);
            if (observer != nullptr) observer->end_chunk();
        }
        if (observer != nullptr) observer->end();
    }

    /// Whoever has taken it is at work on it, for tasks are taken in their order.
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
