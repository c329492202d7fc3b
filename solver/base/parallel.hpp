// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "solver/base/loop_observer.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

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

/// How a loop is cut, and whether threads are worth calling. Chunks do not depend on the latter.
struct Cut {
    std::size_t chunk = CHUNK;
    bool is_light = true;
    Cut() = default;
    Cut(std::size_t items) : chunk(items), is_light(false) {}  // NOLINT: a number is a cut
};

inline void set_threads([[maybe_unused]] int n) {
#ifdef _OPENMP
    omp_set_num_threads(n);
#endif
}

[[nodiscard]] inline int threads() {
#ifdef _OPENMP
    return omp_get_max_threads();
#else
    return 1;
#endif
}

/// Hardware threads that this program may use.
[[nodiscard]] inline int processors() {
#ifdef _OPENMP
    return omp_get_num_procs();
#else
    return 1;
#endif
}

/// Who watches the loops of this run; nobody within a loop that threads share already.
[[nodiscard]] inline LoopObserver* observer_here() {
#ifdef _OPENMP
    if (LoopObserver::running != nullptr && omp_in_parallel() != 0) return nullptr;
#endif
    return LoopObserver::running;
}

[[nodiscard]] inline std::size_t chunk_count(std::size_t n, std::size_t chunk = CHUNK) {
    return (n + chunk - 1) / chunk;
}

/// Chunks that a thread takes at once: some sixteen times each, for taking them costs as well.
[[nodiscard]] inline std::ptrdiff_t taken_at_once(std::ptrdiff_t chunks) {
    constexpr std::ptrdiff_t TIMES = 16;
    const std::ptrdiff_t n = threads();
    return n > 1 ? std::max<std::ptrdiff_t>(1, chunks / (TIMES * n)) : 1;
}

/// body(begin, end, chunk index) for every chunk of 0..n; chunks run in any order.
template <class Body>
void for_chunks(std::size_t n, Body&& body, Cut cut = {}) {
    const std::size_t chunk = cut.chunk;
    const auto chunks = static_cast<std::ptrdiff_t>(chunk_count(n, chunk));
    [[maybe_unused]] const bool is_worth_it = chunks > 1 && (!cut.is_light || n >= WORTH_THREADS);
    LoopObserver* const observer = is_worth_it ? observer_here() : nullptr;
    if (observer != nullptr) observer->begin();
    [[maybe_unused]] const std::ptrdiff_t at_once = taken_at_once(chunks);
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, at_once) if (is_worth_it)
#endif
    for (std::ptrdiff_t c = 0; c < chunks; ++c) {
        const std::size_t begin = static_cast<std::size_t>(c) * chunk;
        body(begin, std::min(n, begin + chunk), static_cast<std::size_t>(c));
        if (observer != nullptr) observer->end_chunk();
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

/// Sum of term(i): chunks first, then the chunks' sums in their order.
template <class T, class Term>
[[nodiscard]] T sum(std::size_t n, T zero, Term&& term, Cut cut = {}) {
    std::vector<T> part(chunk_count(n, cut.chunk), zero);
    for_chunks(
        n,
        [&](std::size_t begin, std::size_t end, std::size_t c) {
            T s = zero;
            for (std::size_t i = begin; i < end; ++i) s += term(i);
            part[c] = s;
        },
        cut);
    T total = zero;
    for (const T& s : part) total += s;
    return total;
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

/// Smallest value(i) and the first i that has it.
struct Least {
    double value;
    std::size_t at;
};
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
