// The wording of errors, and which values the common checks refuse.
#include "math/usage_error.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace carom::detail
{

namespace
{

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

template <class Call>
std::string message_of(Call call)
{
    try
    {
        call();
    }
    catch (const UsageError& error)
    {
        return error.what();
    }
    return "no error";
}

template <class Value>
std::string value_text(Value value)
{
    try
    {
        usage_error("f", "x", value, "r");
    }
    catch (const UsageError& error)
    {
        return error.value();
    }
}

} // namespace

TEST(UsageError, NamesFunctionFieldValueAndRemedy)
{
    const UsageError error("create_body", "position.x", "nan", "give a finite position");
    EXPECT_STREQ(error.what(), "create_body: position.x is nan; give a finite position");
    EXPECT_EQ(error.function(), "create_body");
    EXPECT_EQ(error.field(), "position.x");
    EXPECT_EQ(error.value(), "nan");
    EXPECT_EQ(error.remedy(), "give a finite position");
}

TEST(UsageError, WritesValuesReadably)
{
    EXPECT_EQ(value_text(-0.5f), "-0.5");
    EXPECT_EQ(value_text(0.1f), "0.1");
    EXPECT_EQ(value_text(1e30f), "1e+30");
    EXPECT_EQ(value_text(not_a_number), "nan");
    EXPECT_EQ(value_text(-not_a_number), "nan");
    EXPECT_EQ(value_text(infinity), "inf");
    EXPECT_EQ(value_text(-infinity), "-inf");
    EXPECT_EQ(value_text(0.1), "0.1");
    EXPECT_EQ(value_text(-7), "-7");
    EXPECT_EQ(value_text(18446744073709551615ull), "18446744073709551615");
    EXPECT_EQ(value_text(true), "true");
    EXPECT_EQ(value_text(Vec2{1, -0.5f}), "(1, -0.5)");
    EXPECT_EQ(value_text("stale"), "stale");
}

TEST(UsageError, FiniteCheckNamesTheComponentAndTheNoun)
{
    EXPECT_EQ(message_of([] { require_finite("create_body", "position", Vec2{not_a_number, 0}); }),
              "create_body: position.x is nan; give a finite position");
    EXPECT_EQ(message_of([] { require_finite("create_body", "def.linear_velocity", Vec2{0, -infinity}); }),
              "create_body: def.linear_velocity.y is -inf; give a finite linear velocity");
    EXPECT_EQ(message_of([] { require_finite("f", "polygon.vertices[2]", Vec2{infinity, 0}); }),
              "f: polygon.vertices[2].x is inf; give finite vertices");
    EXPECT_EQ(message_of([] { require_finite("step", "dt", infinity); }), "step: dt is inf; give a finite dt");
    EXPECT_EQ(message_of([] { require_finite("step", "dt", 3e38f); }), "no error");
}

TEST(UsageError, RangeChecksIncludeTheirBounds)
{
    EXPECT_EQ(message_of([] { require_range("step", "dt", 1.5f, 0, 1); }), "step: dt is 1.5; give a value from 0 to 1");
    EXPECT_EQ(message_of([] { require_range("step", "dt", not_a_number, 0, 1); }), "step: dt is nan; give a value from 0 to 1");
    EXPECT_EQ(message_of([] { require_range("step", "dt", 0.0f, 0, 1); }), "no error");
    EXPECT_EQ(message_of([] { require_range("step", "dt", 1.0f, 0, 1); }), "no error");
    EXPECT_EQ(message_of([] { require_range("step", "substeps", 65, 1, 64); }), "step: substeps is 65; give a value from 1 to 64");
    EXPECT_EQ(message_of([] { require_range("step", "substeps", 64, 1, 64); }), "no error");
}

TEST(UsageError, ReachCheckNamesTheComponent)
{
    EXPECT_EQ(message_of([] { require_within("f", "p", {0, -11}, 10); }), "f: p.y is -11; give a value from -10 to 10");
    EXPECT_EQ(message_of([] { require_within("f", "p", {not_a_number, 0}, 10); }), "f: p.x is nan; give a finite p");
    EXPECT_EQ(message_of([] { require_within("f", "p", {10, -10}, 10); }), "no error");
}

TEST(UsageError, SignChecks)
{
    EXPECT_EQ(message_of([] { require_positive("circle", "radius", 0); }), "circle: radius is 0; give a value greater than 0");
    EXPECT_EQ(message_of([] { require_positive("circle", "radius", not_a_number); }), "circle: radius is nan; give a finite radius");
    EXPECT_EQ(message_of([] { require_positive("circle", "radius", 1e-30f); }), "no error");
    EXPECT_EQ(message_of([] { require_not_negative("f", "density", -1); }), "f: density is -1; give a value of 0 or more");
    EXPECT_EQ(message_of([] { require_not_negative("f", "density", infinity); }), "f: density is inf; give a finite density");
    EXPECT_EQ(message_of([] { require_not_negative("f", "density", 0); }), "no error");
}

TEST(UsageError, HandlerIsReplacedAndRestored)
{
    const UsageErrorHandler mine = [](const UsageError&) {};
    const UsageErrorHandler standard = set_usage_error_handler(mine);
    EXPECT_NE(standard, nullptr);
    EXPECT_EQ(set_usage_error_handler(nullptr), mine);
    EXPECT_EQ(set_usage_error_handler(nullptr), standard);
}

} // namespace carom::detail
