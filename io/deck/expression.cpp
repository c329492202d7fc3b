// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "io/text/text.hpp"

namespace corpuscle::io {

namespace {

constexpr int DEEPEST = 200;              ///< nested parentheses and signs: the stack has an end
constexpr double LARGEST_WHOLE = 0x1p53;  ///< a double counts exactly up to here

using Lookup = std::function<std::optional<Value>(std::string_view)>;

struct RealFunction {
    std::string_view name;
    double (*of)(double);
};
const std::array REAL_FUNCTIONS = {
    RealFunction{"SIN", std::sin},     RealFunction{"COS", std::cos},
    RealFunction{"TAN", std::tan},     RealFunction{"ASIN", std::asin},
    RealFunction{"ACOS", std::acos},   RealFunction{"ATAN", std::atan},
    RealFunction{"SINH", std::sinh},   RealFunction{"COSH", std::cosh},
    RealFunction{"TANH", std::tanh},   RealFunction{"ASINH", std::asinh},
    RealFunction{"ACOSH", std::acosh}, RealFunction{"ATANH", std::atanh},
    RealFunction{"SQRT", std::sqrt},   RealFunction{"EXP", std::exp},
    RealFunction{"LOG", std::log},     RealFunction{"LOG10", std::log10},
    RealFunction{"AINT", std::trunc},  RealFunction{"ANINT", std::round},
};

Value checked(double number, bool is_integer) {
    if (!std::isfinite(number)) throw ExpressionError("a finite result");
    if (is_integer && std::abs(number) > LARGEST_WHOLE)
        throw ExpressionError("whole numbers of less than 16 digits");
    return {number, is_integer};
}

Value quotient(Value a, Value b) {
    if (b.number == 0.0) throw ExpressionError("no division by zero");
    const double ratio = a.number / b.number;
    const bool whole = a.is_integer && b.is_integer;
    return checked(whole ? std::trunc(ratio) : ratio, whole);
}

Value power(Value a, Value b) {
    const double result = std::pow(a.number, b.number);
    const bool whole = a.is_integer && b.is_integer;
    return checked(whole ? std::trunc(result) : result, whole);
}

void need(std::size_t count, const std::vector<Value>& arguments, const std::string& name) {
    if (arguments.size() != count)
        throw ExpressionError(
            fmt::format("{} to have {} argument{}", name, count, count == 1 ? "" : "s"));
}

/// Functions whose result is as whole as their arguments, or made whole.
std::optional<Value> whole_function(const std::string& name, const std::vector<Value>& in) {
    const bool whole =
        std::all_of(in.begin(), in.end(), [](const Value& v) { return v.is_integer; });
    if (name == "MIN" || name == "MAX") {
        if (in.empty()) throw ExpressionError(name + " to have arguments");
        double best = in[0].number;
        for (const Value& v : in)
            best = name == "MIN" ? std::min(best, v.number) : std::max(best, v.number);
        return Value{best, whole};
    }
    if (name == "ABS") return need(1, in, name), Value{std::abs(in[0].number), whole};
    if (name == "INT") return need(1, in, name), checked(std::trunc(in[0].number), true);
    if (name == "NINT") return need(1, in, name), checked(std::round(in[0].number), true);
    if (name == "FLOAT" || name == "REAL") return need(1, in, name), Value{in[0].number, false};
    if (name == "SIGN")
        return need(2, in, name), Value{std::copysign(in[0].number, in[1].number), whole};
    if (name == "MOD") {
        need(2, in, name);
        if (in[1].number == 0.0) throw ExpressionError("no division by zero");
        return Value{std::fmod(in[0].number, in[1].number), whole};
    }
    return {};
}

Value call(const std::string& name, const std::vector<Value>& in) {
    if (const auto value = whole_function(name, in)) return *value;
    if (name == "ATAN2") return need(2, in, name), Value{std::atan2(in[0].number, in[1].number)};
    for (const RealFunction& f : REAL_FUNCTIONS)
        if (f.name == name) return need(1, in, name), checked(f.of(in[0].number), false);
    throw ExpressionError(fmt::format("a known function instead of {}", name));
}

/// Recursive descent, one method a level of precedence.
class Parser {
public:
    Parser(std::string_view text, const Lookup& lookup) : rest_(text), lookup_(lookup) {}

    Value whole_text() {
        const Value value = sum();
        skip_blanks();
        if (!rest_.empty()) throw ExpressionError(fmt::format("an operator before \"{}\"", rest_));
        return value;
    }

private:
    Value sum() {
        Value a = product();
        for (;;) {
            if (accept("+")) {
                const Value b = product();
                a = checked(a.number + b.number, a.is_integer && b.is_integer);
            } else if (accept("-")) {
                const Value b = product();
                a = checked(a.number - b.number, a.is_integer && b.is_integer);
            } else {
                return a;
            }
        }
    }

    Value product() {
        Value a = signed_power();
        for (;;) {
            if (!starts_with("**") && accept("*")) {
                const Value b = signed_power();
                a = checked(a.number * b.number, a.is_integer && b.is_integer);
            } else if (accept("/")) {
                a = quotient(a, signed_power());
            } else {
                return a;
            }
        }
    }

    /// A sign binds less than **: -2**2 = -4, as in Fortran.
    Value signed_power() {
        if (++depth_ > DEEPEST) throw ExpressionError("less nesting");
        Value value;
        if (accept("-")) {
            value = signed_power();
            value.number = -value.number;
        } else if (accept("+")) {
            value = signed_power();
        } else {
            value = atom();
            if (accept("**")) value = power(value, signed_power());
        }
        --depth_;
        return value;
    }

    Value atom() {
        if (accept("(")) {
            const Value value = sum();
            if (!accept(")")) throw ExpressionError("a closing parenthesis");
            return value;
        }
        skip_blanks();
        if (rest_.empty()) throw ExpressionError("a number or a name at the end");
        const char c = rest_.front();
        if ((c >= '0' && c <= '9') || c == '.') return number();
        return named();
    }

    Value number() {
        double value = 0.0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc{})
            throw ExpressionError(fmt::format("a number instead of \"{}\"", rest_));
        const auto token = rest_.substr(0, static_cast<std::size_t>(end - rest_.data()));
        rest_.remove_prefix(token.size());
        return checked(value, token.find_first_of(".eE") == std::string_view::npos);
    }

    Value named() {
        const bool marked = accept("&");
        std::size_t n = 0;
        while (n < rest_.size() && is_name(rest_[n])) ++n;
        if (n == 0) throw ExpressionError(fmt::format("a number or a name at \"{}\"", rest_));
        const std::string_view name = rest_.substr(0, n);
        rest_.remove_prefix(n);
        if (!marked && accept("(")) return call(upper(name), arguments());
        if (const auto value = lookup_(name)) return *value;
        throw ExpressionError(fmt::format("a *PARAMETER named {}", name));
    }

    std::vector<Value> arguments() {
        std::vector<Value> in;
        if (accept(")")) return in;
        do in.push_back(sum());
        while (accept(","));
        if (!accept(")")) throw ExpressionError("a closing parenthesis");
        return in;
    }

    static bool is_name(char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_';
    }
    void skip_blanks() {
        while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t'))
            rest_.remove_prefix(1);
    }
    bool starts_with(std::string_view token) {
        skip_blanks();
        return rest_.substr(0, token.size()) == token;
    }
    bool accept(std::string_view token) {
        if (!starts_with(token)) return false;
        rest_.remove_prefix(token.size());
        return true;
    }

    std::string_view rest_;
    const Lookup& lookup_;
    int depth_ = 0;
};

}  // namespace

Value evaluate(std::string_view text, const Lookup& lookup) {
    return Parser(text, lookup).whole_text();
}

}  // namespace corpuscle::io
