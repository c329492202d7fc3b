// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

namespace corpuscle {

/// out[l] = a[from[l]], of vectors of the compiler's; clang has it only for constants.
template <class Vector, class Lanes>
[[nodiscard]] inline Vector shuffled(const Vector& a, const Lanes& from) {
#ifdef __clang__
    Vector out = a;
    for (unsigned l = 0; l < sizeof(Vector) / sizeof(a[0]); ++l) out[l] = a[from[l]];
    return out;
#else
    return __builtin_shuffle(a, from);
#endif
}

}  // namespace corpuscle
