// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/study/study.hpp"

namespace corpuscle::study {

/// Every factor and fixed value is a parameter of every deck that is run, and every response has
/// the form of one, a vector's with the part that is meant: what no run could come to is found
/// before the first.
/// @throws InputError with every fault: the study, the name, what there is
void expect_known_names(const Study& study);

}  // namespace corpuscle::study
