// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "solver/base/loops.hpp"

/// What loops in chunks make of their items.
namespace corpuscle::parallel {

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

/// Sorts items by a strict order in which no two are alike: short runs first, then two by two.
/// @param spare  kept for its memory
template <class T, class Less>
void sort(std::span<T> items, std::vector<T>& spare, Less&& less,
          Cut::Where where = Cut::Where::current()) {
    constexpr std::size_t RUN = 128;
    const std::size_t n = items.size();
    spare.resize(std::max(spare.size(), n));
    std::size_t merges = 0;
    while (RUN << merges < n) ++merges;
    const auto stage = [&](std::size_t k) {
        const auto over_run = [items, n, k, &spare, &less](std::size_t run) {
            const std::size_t length = RUN << k, first = run * length,
                              last = std::min(n, first + length);
            T* const from = k % 2 == 1 ? items.data() : spare.data();
            T* const to = k % 2 == 1 ? spare.data() : items.data();
            if (k == 0) return std::sort(to + first, to + last, less);
            const std::size_t middle = std::min(n, first + length / 2);
            std::merge(from + first, from + middle, from + middle, from + last, to + first, less);
        };
        return each(chunk_count(n, RUN << k), over_run, Cut(1, where));
    };
    in_turn(merges + 1, stage);
    if (merges % 2 == 1)
        for_each(
            n, [&](std::size_t i) { items[i] = spare[i]; }, Cut(where));
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
