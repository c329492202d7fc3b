// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <array>
#include <map>

#include "io/deck/expression.hpp"
#include "io/text/text.hpp"

using namespace corpuscle;
using namespace corpuscle::io;

TEST_CASE("a number may have a Fortran exponent, with D or without any letter", "[io]") {
    CHECK(parse_real("1.0-4") == 1.0e-4);
    CHECK(parse_real("-2.5+3") == -2.5e3);
    CHECK(parse_real("1d3") == 1000.0);
    CHECK(parse_real("1.5D-02") == 0.015);
    CHECK(parse_real("+.5") == 0.5);
    CHECK(parse_real("5.") == 5.0);
    CHECK(parse_real(" 1.E+05 ") == 1e5);
    CHECK(parse_real("7") == 7.0);
}

TEST_CASE("what is not one finite number is none", "[io]") {
    const std::string text =
        GENERATE("", " ", "abc", "1.0x", "1 2", "1e", "--1", "+-1", "1e5e5", "1-2-3", "nan", "inf",
                 "-inf", "1e999", "0x10", ".", "e5", "1.2.3", "-", "1e+-5");
    CAPTURE(text);
    CHECK_FALSE(parse_real(text));
}

TEST_CASE("a whole number may be written as a real one", "[io]") {
    CHECK(parse_integer("12") == 12);
    CHECK(parse_integer("1.0") == 1);
    CHECK(parse_integer("-3.") == -3);
    CHECK(parse_integer("2.e3") == 2000);
    CHECK(parse_integer("+4") == 4);
    CHECK(parse_integer("2147483647") == 2147483647);
    CHECK_FALSE(parse_integer("2147483648"));
    CHECK_FALSE(parse_integer("1.5"));
    CHECK_FALSE(parse_integer("99999999999999999999"));
    CHECK_FALSE(parse_integer("1e300"));
}

TEST_CASE("the edit distance counts a swap of neighbours once", "[io]") {
    CHECK(edit_distance("", "") == 0);
    CHECK(edit_distance("NODE", "") == 4);
    CHECK(edit_distance("NODE", "NODE") == 0);
    CHECK(edit_distance("NDOE", "NODE") == 1);
    CHECK(edit_distance("NODES", "NODE") == 1);
    CHECK(edit_distance("PRAT", "PART") == 1);
    CHECK(edit_distance("SITTING", "KITTEN") == 3);
    const std::array<std::string_view, 2> known = {"PART", "NODE"};
    CHECK(nearest("PRAT", known) == "PART");
    CHECK(nearest("COMPLETELY_DIFFERENT", known).empty());
}

namespace {

double value_of(std::string_view text) {
    const std::map<std::string, Value, std::less<>> known = {{"two", {2.0, true}},
                                                             {"half", {0.5, false}}};
    return evaluate(text,
                    [&](std::string_view name) -> std::optional<Value> {
                        const auto at = known.find(name);
                        return at == known.end() ? std::nullopt : std::optional(at->second);
                    })
        .number;
}

}  // namespace

TEST_CASE("expressions follow the usual precedence", "[io]") {
    CHECK(value_of("1 + 2*3") == 7.0);
    CHECK(value_of("(1+2)*3") == 9.0);
    CHECK(value_of("2 - 3 - 4") == -5.0);
    CHECK(value_of("24./4./2.") == 3.0);
    CHECK(value_of("-2**2") == -4.0);
    CHECK(value_of("2**3**2") == 512.0);
    CHECK(value_of("2**-1.0") == 0.5);
    CHECK(value_of("2*-3") == -6.0);
    CHECK(value_of("1.5e-3*2") == 3e-3);
}

TEST_CASE("whole numbers divide to whole numbers", "[io]") {
    CHECK(value_of("2/5") == 0.0);
    CHECK(value_of("-7/2") == -3.0);
    CHECK(value_of("2.0/5") == 0.4);
    CHECK(value_of("two/5") == 0.0);
    CHECK(value_of("float(two)/5") == 0.4);
}

TEST_CASE("expressions know parameters and functions", "[io]") {
    CHECK(value_of("&two*half") == 1.0);
    CHECK(value_of("max(1, two, half)") == 2.0);
    CHECK(value_of("MIN(1, half)") == 0.5);
    CHECK(value_of("sqrt(16.0)+abs(-1)") == 5.0);
    CHECK(value_of("mod(7,3)") == 1.0);
    CHECK(value_of("nint(2.6)/2") == 1.0);
    CHECK(value_of("int(2.6)") == 2.0);
    CHECK(value_of("sign(3, -1)") == -3.0);
    CHECK(value_of("atan2(1.0, 1.0)") == Approx(0.785398163397));
    CHECK(value_of("sin(0.5)**2 + cos(0.5)**2") == Approx(1.0));
}

TEST_CASE("a bad expression says what it should be", "[io]") {
    const std::string text = GENERATE("", "1+", "(1", "1)", "nobody", "1/0", "1.0/0.0",
                                      "sqrt(-1.0)", "log(0.0)", "foo(1)", "max()", "mod(1)",
                                      "mod(1,0)", "1 2", "10**400", "*", "&", "2,3", "exp(1e9)");
    CAPTURE(text);
    CHECK_THROWS_AS(value_of(text), ExpressionError);
}

TEST_CASE("nesting without end is refused, not followed", "[io]") {
    CHECK_THROWS_AS(value_of(std::string(100000, '(')), ExpressionError);
    CHECK_THROWS_AS(value_of(std::string(100000, '-') + "1"), ExpressionError);
    CHECK_THROWS_AS(value_of("2" + std::string(100000, '*')), ExpressionError);
}
