// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace corpuscle::io {

/// A number that remembers whether it is whole: 2/5 is 0, 2.0/5 is 0.4, as in LS-DYNA.
struct Value {
    double number = 0.0;
    bool is_integer = false;
};

/// What is wrong with an expression, in words that continue "expected".
struct ExpressionError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Value of `text`: numbers, names (with or without &), + - * / **, parentheses and Fortran's
/// functions.
///
/// @param lookup  value of a name, none when there is no such parameter
/// @throws ExpressionError
Value evaluate(std::string_view text,
               const std::function<std::optional<Value>(std::string_view name)>& lookup);

}  // namespace corpuscle::io
