// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "solver/base/call_site.hpp"
#include "solver/base/loop_observer.hpp"
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

/// Who watches the loops of this run; nobody within a loop that threads share already.
[[nodiscard]] inline LoopObserver* observer_here() {
#ifdef _OPENMP
    if (LoopObserver::running != nullptr && omp_in_parallel() != 0) return nullptr;
#endif
    return LoopObserver::running;
}

/// Chunks that n items are cut into; the last may be shorter.
[[nodiscard]] inline std::size_t chunk_count(std::size_t n, std::size_t chunk = CHUNK) {
    return (n + chunk - 1) / chunk;
}

/// Chunks that a thread takes at once: some sixteen times each, for taking them costs as well; one
/// thread takes them all.
[[nodiscard]] inline std::ptrdiff_t taken_at_once(std::ptrdiff_t chunks) {
    constexpr std::ptrdiff_t TIMES = 16;
    const std::ptrdiff_t n = threads();
    return std::max<std::ptrdiff_t>(1, n > 1 ? chunks / (TIMES * n) : chunks);
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

/// body(c) for every c in 0..chunks, in any order.
template <class Body>
void deal_out(std::size_t chunks, Body&& body, bool is_worth_it, const Cut::Where& where) {
    LoopObserver* const observer = is_worth_it ? observer_here() : nullptr;
    if (observer != nullptr) observer->begin(where);
    const auto count = static_cast<std::ptrdiff_t>(chunks);
    [[maybe_unused]] const std::ptrdiff_t at_once = taken_at_once(count);
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, at_once) if (is_worth_it)
#endif
    for (std::ptrdiff_t c = 0; c < count; ++c) {
        body(static_cast<std::size_t>(c));
        if (observer != nullptr) observer->end_chunk();
    }
    if (observer != nullptr) observer->end();
}

/// body(begin, end, chunk index) for every chunk of 0..n; chunks run in any order.
template <class Body>
void for_chunks(std::size_t n, Body&& body, Cut cut = {}) {
    const Loop<Body&> loop{n, body, cut};
    deal_out(
        loop.chunks(), [&](std::size_t c) { loop.run(c); }, loop.is_worth_threads(), cut.where);
}

/// Loops none of which needs what another does, in one call of the threads. Those named first begin
/// first.
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
    deal_out(chunks, run, chunks > 1 && (!is_light || items >= WORTH_THREADS), first(loops...));
}

/// A thread's part of one of several loops in turn.
template <class Body>
void share(const Loop<Body>& loop, LoopObserver* observer) {
    const auto chunks = static_cast<std::ptrdiff_t>(loop.chunks());
    const bool is_shared = loop.is_worth_threads();
    [[maybe_unused]] const std::ptrdiff_t at_once =
        is_shared ? taken_at_once(chunks) : std::max<std::ptrdiff_t>(1, chunks);
#ifdef _OPENMP
#pragma omp for schedule(dynamic, at_once)
#endif
    for (std::ptrdiff_t c = 0; c < chunks; ++c) {
        loop.run(static_cast<std::size_t>(c));
        if (observer != nullptr && (is_shared || c + 1 == chunks)) observer->end_chunk();
    }
#ifdef _OPENMP
#pragma omp master
#endif
    if (observer != nullptr) observer->end_stage();
}

/// loop_of(0), loop_of(1), ..., each of which needs what the one before has done, in one call of
/// the threads: they wait for each other after each of them.
template <class LoopOf>
void in_turn(std::size_t loops, LoopOf&& loop_of) {
    bool is_worth_it = false;
    for (std::size_t k = 0; k < loops; ++k) is_worth_it |= loop_of(k).is_worth_threads();
    LoopObserver* const observer = is_worth_it ? observer_here() : nullptr;
    if (observer != nullptr) observer->begin(loop_of(std::size_t{0}).cut.where);
#ifdef _OPENMP
#pragma omp parallel if (is_worth_it)
#endif
    for (std::size_t k = 0; k < loops; ++k) share(loop_of(k), observer);
    if (observer != nullptr) observer->end();
}

/// Likewise of loops whose lengths are known ahead.
template <class First, class... More>
void in_turn(const Loop<First>& first, const Loop<More>&... more) {
    const bool is_worth_it = first.is_worth_threads() || (more.is_worth_threads() || ...);
    LoopObserver* const observer = is_worth_it ? observer_here() : nullptr;
    if (observer != nullptr) observer->begin(first.cut.where);
#ifdef _OPENMP
#pragma omp parallel if (is_worth_it)
#endif
    {
        share(first, observer);
        (share(more, observer), ...);
    }
    if (observer != nullptr) observer->end();
}

/// body(i) for every i in 0..n, in any order.
template <class Body>
void for_each(std::size_t n, Body&& body, Cut cut = {}) {
    for_chunks(
        n,
        [&](std::size_t begin, std::size_t end, std::size_t) {
            for (std::size_t i = begin; i < end; ++i) body(i);
        },
        cut);
}

/// to = from.
template <class T>
void copy(const std::vector<T>& from, std::vector<T>& to) {
    to.resize(from.size());
    for_each(from.size(), [&](std::size_t i) { to[i] = from[i]; });
}

/// What join(all, i) makes of `start` over every i in 0..n: each chunk from `start` on, then the
/// chunks' in their order, by merge(all, chunk).
template <class T, class Join, class Merge>
[[nodiscard]] T fold(std::size_t n, const T& start, Join&& join, Merge&& merge, Cut cut = {}) {
    std::vector<T> part(chunk_count(n, cut.chunk), start);
    for_chunks(
        n,
        [&](std::size_t begin, std::size_t end, std::size_t c) {
            T own = start;
            for (std::size_t i = begin; i < end; ++i) join(own, i);
            part[c] = own;
        },
        cut);
    T all = start;
    for (const T& own : part) merge(all, own);
    return all;
}

/// Sum of term(i): chunks first, then the chunks' sums in their order.
template <class T, class Term>
[[nodiscard]] T sum(std::size_t n, T zero, Term&& term, Cut cut = {}) {
    return fold(
        n, zero, [&](T& all, std::size_t i) { all += term(i); },
        [](T& all, const T& more) { all += more; }, cut);
}

/// What a loop finds here and there: by chunk, then put together in the items' order.
template <class T>
class Gathered {
public:
    /// body(i, take) for every i in 0..n; what it takes is added to `all`.
    template <class Body>
    void find(std::size_t n, std::vector<T>& all, Body&& body, Cut cut = {}) {
        const std::size_t chunks = chunk_count(n, cut.chunk);
        if (by_chunk_.size() < chunks) by_chunk_.resize(chunks);
        for_chunks(
            n,
            [&](std::size_t begin, std::size_t end, std::size_t c) {
                std::vector<T>& mine = by_chunk_[c];
                mine.clear();
                for (std::size_t i = begin; i < end; ++i)
                    body(i, [&](const T& found) { mine.push_back(found); });
            },
            cut);
        for (std::size_t c = 0; c < chunks; ++c)
            all.insert(all.end(), by_chunk_[c].begin(), by_chunk_[c].end());
    }

private:
    std::vector<std::vector<T>> by_chunk_;
};

/// Smallest value(i) and the first i that has it; `start` and n where none is below `start`.
struct Least {
    double value;    ///< the smallest, in the caller's units
    std::size_t at;  ///< its i
};
/// value(i) over 0..n, a double without side effects; NaN is never the least.
template <class Value>
[[nodiscard]] Least least(std::size_t n, double start, Value&& value, Cut cut = {}) {
    std::vector<Least> part(chunk_count(n, cut.chunk), Least{start, n});
    for_chunks(
        n,
        [&](std::size_t begin, std::size_t end, std::size_t c) {
            Least low{start, n};
            for (std::size_t i = begin; i < end; ++i)
                if (const double v = value(i); v < low.value) low = {v, i};
            part[c] = low;
        },
        cut);
    Least low{start, n};
    for (const Least& p : part)
        if (p.value < low.value) low = p;
    return low;
}

}  // namespace corpuscle::parallel
