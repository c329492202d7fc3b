// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <type_traits>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/base/threads.hpp"

namespace corpuscle::parallel {

/// Threads that run loops together. One calls, the others wait for its call: at first spinning,
/// because calls follow each other within microseconds, then asleep, which frees the core. A thread
/// that has spun in vain spins less the next time: where other programs use the cores, spinning
/// threads only delay each other.
///
/// A call, and each barrier within it, begins a phase. Every member marks the end of its phase in a
/// cache line of its own; the caller waits for all of them and begins the next phase.
class Team {
public:
    /// Throws SystemError where the system gives no more threads.
    explicit Team(int size) : size_(size), seats_(static_cast<std::size_t>(size)) {
        try {
            for (int m = 1; m < size; ++m) members_.emplace_back([this, m] { serve(m); });
        } catch (const std::system_error& error) {
            end();
            throw SystemError("cannot start " + std::to_string(size) + " threads: " + error.what());
        }
    }
    /// No call may be in progress.
    ~Team() { end(); }
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    [[nodiscard]] int size() const { return size_; }  ///< threads, the caller among them

    /// work(member) for 0..size()-1, on a thread each; member 0 is the caller. An exception ends
    /// the program.
    template <class Work>
    void call(Work&& work) {
        const auto run = [](void* what, int member) noexcept {
            (*static_cast<std::remove_reference_t<Work>*>(what))(member);
        };
        work_ = run;
        what_ = const_cast<void*>(static_cast<const void*>(&work));
        begin_phase();
        run(what_, 0);
        wait_for_others();
    }

    /// Barrier of all members, within a call.
    void meet(int member) {
        if (member == 0) {
            wait_for_others();
            begin_phase();
        } else {
            arrive(member);
            wait_for_phase(member);
        }
    }

    /// Runs body(chunk) for a loop's chunks. Every member has the same contiguous share in each
    /// loop, so data stay in its core's cache from loop to loop.
    template <class Body>
    void go_through_share(int member, std::size_t chunks, Body&& body) {
        for (std::size_t c = begin_of(member, chunks); c < begin_of(member + 1, chunks); ++c)
            body(c);
    }

    /// Likewise; a member that has finished its share takes chunks that others have not begun.
    template <class Body>
    void go_through_shares(int member, std::size_t chunks, Body&& body) {
        go_through_lists(
            member,
            [&](int whose) { return begin_of(whose + 1, chunks) - begin_of(whose, chunks); },
            [&](int whose, std::size_t k) { body(begin_of(whose, chunks) + k); });
    }

    /// Likewise for lists of the members: body(whose, k) for k in 0..count(whose). A list is run in
    /// its order; members that have finished their own help with others.
    template <class Count, class Body>
    void go_through_lists(int member, Count&& count, Body&& body) {
        const std::uint64_t phase = seat(member).phase;
        for (int k = 0; k < size_; ++k) {
            const int whose = member + k < size_ ? member + k : member + k - size_;
            const std::size_t all = count(whose);
            for (std::size_t c; (c = seat(whose).take(phase, all)) < all;) body(whose, c);
        }
    }

private:
    static constexpr std::size_t LINE = 64;  ///< of a cache                              [bytes]
    /// Spins of a wait, 10 to 40 ns each, before the thread leaves its core to others.
    static constexpr int MOST_SPINS = 4096, LEAST_SPINS = 64;

    struct alignas(LINE) Seat {
        std::atomic<std::uint32_t> done{0};  ///< last phase that it has finished
        std::uint32_t phase = 0;             ///< its current phase
        int patience = MOST_SPINS;           ///< spins before it sleeps
        alignas(LINE) std::atomic<std::uint64_t> taken{
            0};  ///< of its share: phase, chunks begun in it

        /// The next chunk of a share of `count`; `count`: none is left.
        std::size_t take(std::uint64_t in_phase, std::size_t count) {
            std::uint64_t now = taken.load(std::memory_order_relaxed);
            for (;;) {
                const std::uint64_t begun = now >> 32 == in_phase ? now & 0xffffffffU : 0;
                if (begun >= count) return count;
                if (taken.compare_exchange_weak(now, in_phase << 32 | (begun + 1),
                                                std::memory_order_relaxed))
                    return begun;
            }
        }
    };

    /// Spins until is_over(), or until patience ends.
    /// @returns  is_over()
    template <class Over>
    [[nodiscard]] bool spin(Seat& waits, Over&& is_over) const {
        if (size_ > processors()) return is_over();  // spinning would delay the other threads
        for (int i = waits.patience; i > 0; --i, pause())
            if (is_over()) {
                waits.patience = std::min(2 * waits.patience, MOST_SPINS);
                return true;
            }
        waits.patience = std::max(waits.patience / 2, LEAST_SPINS);
        return false;
    }

    Seat& seat(int member) { return seats_[static_cast<std::size_t>(member)]; }
    /// Chunk with which a member's share begins.
    [[nodiscard]] std::size_t begin_of(int member, std::size_t chunks) const {
        return chunks * static_cast<std::size_t>(member) / static_cast<std::size_t>(size_);
    }

    static void pause() {
#ifdef __x86_64__
        __builtin_ia32_pause();
#else
        std::this_thread::yield();
#endif
    }

    void end() {
        work_ = nullptr;
        begin_phase();
        for (std::thread& member : members_) member.join();
    }
    void serve(int member) {
        for (;;) {
            wait_for_phase(member);
            if (work_ == nullptr) return;
            work_(what_, member);
            arrive(member);
        }
    }
    void begin_phase() {
        phase_.store(++seat(0).phase, std::memory_order_seq_cst);
        phase_.notify_all();
    }
    void wait_for_phase(int member) {
        Seat& own = seat(member);
        const auto has_begun = [&] { return phase_.load(std::memory_order_acquire) != own.phase; };
        if (!spin(own, has_begun)) phase_.wait(own.phase, std::memory_order_acquire);
        ++own.phase;
    }
    void arrive(int member) {
        seat(member).done.store(seat(member).phase, std::memory_order_release);
    }
    void wait_for_others() {
        Seat& own = seat(0);
        for (int m = 1; m < size_; ++m) {
            const auto has_arrived = [&] {
                return seat(m).done.load(std::memory_order_acquire) == own.phase;
            };
            if (spin(own, has_arrived)) continue;
            while (!has_arrived()) std::this_thread::yield();
        }
    }

    int size_;
    alignas(LINE) std::atomic<std::uint32_t> phase_{0};
    void (*work_)(void*, int) noexcept = nullptr;
    void* what_ = nullptr;
    std::vector<Seat> seats_;
    std::vector<std::thread> members_;
};

/// Access to the team of this process: one call at a time, no nested calls.
class Call {
public:
    /// Whether this thread is in a call already: it runs nested loops alone.
    [[nodiscard]] static bool is_under_way() { return is_at_work; }

    /// work(team, member) on all threads() of them.
    /// @returns  false, without work done, while another thread has the team
    template <class Work>
    [[nodiscard]] static bool make(Work&& work) {
        Held& held = of_process();
        if (held.is_busy.test_and_set(std::memory_order_acquire)) return false;
        const Release release(held.is_busy);
        if (held.team == nullptr || held.team->size() != threads()) {
            held.team.reset();
            held.team = std::make_unique<Team>(threads());
        }
        Team& team = *held.team;
        team.call([&](int member) {
            is_at_work = true;
            work(team, member);
            is_at_work = false;
        });
        return true;
    }

private:
    struct Release {
        explicit Release(std::atomic_flag& flag) : flag_(flag) {}
        ~Release() { flag_.clear(std::memory_order_release); }
        Release(const Release&) = delete;
        Release& operator=(const Release&) = delete;

    private:
        std::atomic_flag& flag_;
    };
    struct Held {
        /// A forked process has none of the threads: it starts a team of its own and leaves the
        /// copied one untouched.
        Held() {
            pthread_atfork(nullptr, nullptr, [] {
                static_cast<void>(of_process().team.release());
                of_process().is_busy.clear();
            });
        }
        std::unique_ptr<Team> team;
        std::atomic_flag is_busy;
    };
    static Held& of_process() {
        static Held held;
        return held;
    }

    inline static thread_local bool is_at_work = false;
};

}  // namespace corpuscle::parallel
