// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "solver/base/call_site.hpp"
#include "solver/base/loop_observer.hpp"
#include "solver/base/team.hpp"
#include "solver/base/threads.hpp"

/// The only place that knows about threads.
///
/// Work is cut into chunks whose borders do not depend on the number of threads, and whatever
/// chunks produce is combined in chunk order: the same bits on 1 or 64 threads.
namespace corpuscle::parallel {

/// Items a chunk: 6 000 nodes are enough for 16 threads, and a call costs less than one of them.
inline constexpr std::size_t CHUNK = 128;

/// Loops that are not told their chunk are light, some nanoseconds an item: with fewer items than
/// this one thread is done before it could have called the others.
inline constexpr std::size_t WORTH_THREADS = 4096;

/// How a loop is cut, whether threads are worth calling, and which loop it is. Chunks depend on the
/// first alone.
struct Cut {
    using Where = CallSite;     ///< file and line, its name in traces
    std::size_t chunk = CHUNK;  ///< items a chunk; the order of sums hangs on it alone
    bool is_light = true;       ///< threads help from WORTH_THREADS items on, else from 2 chunks
    Where where;                ///< of the call
    /// A light loop in chunks of CHUNK.
    Cut(Where call = Where::current()) : where(call) {}  // NOLINT: {} is a cut
    /// A heavy loop, worth threads from two chunks of `items` on.
    Cut(std::size_t items, Where call = Where::current())  // NOLINT: a number is a cut
        : chunk(items), is_light(false), where(call) {}
};

/// Distribution of a loop's chunks over threads.
enum class Shares : std::uint8_t {
    EVEN,   ///< each thread its own: chunks of like cost
    HELPED  ///< threads that have finished their share help others
};

/// Chunks of a light loop cost alike.
[[nodiscard]] inline Shares shares_of(const Cut& cut) {
    return cut.is_light ? Shares::EVEN : Shares::HELPED;
}

/// Observer of the loops of this run; none within a loop that threads share already.
[[nodiscard]] inline LoopObserver* observer_here() {
    return Call::is_under_way() ? nullptr : LoopObserver::running;
}

/// Chunks that n items are cut into; the last may be shorter.
[[nodiscard]] inline std::size_t chunk_count(std::size_t n, std::size_t chunk = CHUNK) {
    return (n + chunk - 1) / chunk;
}

/// A loop that runs with others: what for_chunks() takes.
template <class Body>
struct Loop {
    std::size_t n;  ///< items
    Body body;      ///< body(begin, end, chunk index)
    Cut cut;        ///< as for_chunks() takes it

    [[nodiscard]] std::size_t chunks() const { return chunk_count(n, cut.chunk); }  ///< of all
    /// Whether it has more chunks than one, and work enough for the call of the threads.
    [[nodiscard]] bool is_worth_threads() const {
        return chunks() > 1 && (!cut.is_light || n >= WORTH_THREADS);
    }
    /// Chunk c alone, on the calling thread.
    void run(std::size_t c) const {
        const std::size_t begin = c * cut.chunk;
        body(begin, std::min(n, begin + cut.chunk), c);
    }
};

/// body(i) for every i in 0..n.
template <class Body>
[[nodiscard]] auto each(std::size_t n, Body body, Cut cut = {}) {
    auto over_chunk = [body](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end; ++i) body(i);
    };
    return Loop<decltype(over_chunk)>{n, over_chunk, cut};
}

/// body(), on one thread.
template <class Body>
[[nodiscard]] auto alone(Body body, Cut::Where where = Cut::Where::current()) {
    auto all = [body](std::size_t, std::size_t, std::size_t) { body(); };
    return Loop<decltype(all)>{1, all, Cut(1, where)};
}

/// work(team, member) by all threads, or alone() on this one: where there are no others, or they
/// or this one are within a call.
template <class Work, class Alone>
void call_threads(bool is_worth_it, Work&& work, Alone&& alone) {
    if (!is_worth_it || threads() == 1 || Call::is_under_way() || !Call::make(work)) alone();
}

/// body(c) for every c in 0..chunks, in any order.
template <class Body>
void deal_out(std::size_t chunks, Body&& body, bool is_worth_it, Shares shares,
              const Cut::Where& where) {
    LoopObserver* const observer = is_worth_it ? observer_here() : nullptr;
    if (observer != nullptr) observer->begin(where);
    const auto run = [&](std::size_t c) {
        body(c);
        if (observer != nullptr) observer->end_chunk();
    };
    call_threads(
        is_worth_it,
        [&](Team& team, int member) {
            if (shares == Shares::EVEN)
                team.go_through_share(member, chunks, run);
            else
                team.go_through_shares(member, chunks, run);
        },
        [&] {
            for (std::size_t c = 0; c < chunks; ++c) run(c);
        });
    if (observer != nullptr) observer->end();
}

/// body(begin, end, chunk index) for every chunk of 0..n; chunks run in any order.
template <class Body>
void for_chunks(std::size_t n, Body&& body, Cut cut = {}) {
    const Loop<Body&> loop{n, body, cut};
    deal_out(
        loop.chunks(), [&](std::size_t c) { loop.run(c); }, loop.is_worth_threads(), shares_of(cut),
        cut.where);
}

/// Loops none of which needs what another does, in one call of the threads.
template <class... Bodies>
void side_by_side(const Loop<Bodies>&... loops) {
    const auto run = [&](std::size_t c) {
        const auto is_of = [&](const auto& loop) {
            if (c < loop.chunks()) {
                loop.run(c);
                return true;
            }
            c -= loop.chunks();
            return false;
        };
        static_cast<void>((is_of(loops) || ...));
    };
    const auto first = [](const auto& loop, const auto&...) { return loop.cut.where; };
    const std::size_t chunks = (loops.chunks() + ...), items = (loops.n + ...);
    const bool is_light = ((loops.cut.is_light || loops.n == 0) && ...);
    deal_out(chunks, run, chunks > 1 && (!is_light || items >= WORTH_THREADS), Shares::HELPED,
             first(loops...));
}

/// A member's part of one of several loops in turn.
template <class Body>
void share(const Loop<Body>& loop, Team& team, int member) {
    const auto run = [&](std::size_t c) { loop.run(c); };
    if (!loop.is_worth_threads()) {
        for (std::size_t c = 0; member == 0 && c < loop.chunks(); ++c) run(c);
    } else if (shares_of(loop.cut) == Shares::EVEN) {
        team.go_through_share(member, loop.chunks(), run);
    } else {
        team.go_through_shares(member, loop.chunks(), run);
    }
}

/// One of several loops in turn, on this thread.
template <class Body>
void go_through(const Loop<Body>& loop, LoopObserver* observer) {
    for (std::size_t c = 0; c < loop.chunks(); ++c) {
        loop.run(c);
        if (observer != nullptr && (loop.is_worth_threads() || c + 1 == loop.chunks()))
            observer->end_chunk();
    }
    if (observer != nullptr) observer->end_stage();
}

/// loop_of(0), loop_of(1), ..., each of which needs what the one before has done, in one call of
/// the threads: they meet after each of them.
template <class LoopOf>
void in_turn(std::size_t loops, LoopOf&& loop_of) {
    bool is_worth_it = false;
    for (std::size_t k = 0; k < loops; ++k) is_worth_it |= loop_of(k).is_worth_threads();
    LoopObserver* const observer = is_worth_it ? observer_here() : nullptr;
    if (observer != nullptr) observer->begin(loop_of(std::size_t{0}).cut.where);
    call_threads(
        is_worth_it,
        [&](Team& team, int member) {
            for (std::size_t k = 0; k < loops; ++k) {
                if (k > 0) team.meet(member);
                share(loop_of(k), team, member);
            }
        },
        [&] {
            for (std::size_t k = 0; k < loops; ++k) go_through(loop_of(k), observer);
        });
    if (observer != nullptr) observer->end();
}

/// Likewise of loops whose lengths are known ahead.
template <class First, class... More>
void in_turn(const Loop<First>& first, const Loop<More>&... more) {
    const bool is_worth_it = first.is_worth_threads() || (more.is_worth_threads() || ...);
    LoopObserver* const observer = is_worth_it ? observer_here() : nullptr;
    if (observer != nullptr) observer->begin(first.cut.where);
    call_threads(
        is_worth_it,
        [&](Team& team, int member) {
            share(first, team, member);
            ((team.meet(member), share(more, team, member)), ...);
        },
        [&] {
            go_through(first, observer);
            (go_through(more, observer), ...);
        });
    if (observer != nullptr) observer->end();
}

}  // namespace corpuscle::parallel
