// What the tests of bad input ask of every refusal. Test code only.
#pragma once

#include <carom/error.hpp>

#include <gtest/gtest.h>

#include <string>

namespace carom
{

/// A call must throw UsageError that names the function and the field, and says what was given and what to do.
template <class Call>
void expect_refused(const std::string& function, const std::string& field, Call&& call)
{
    try
    {
        call();
        ADD_FAILURE() << function << " took a bad " << field;
    }
    catch (const UsageError& error)
    {
        EXPECT_EQ(error.function(), function) << error.what();
        EXPECT_EQ(error.field(), field) << error.what();
        EXPECT_FALSE(error.value().empty()) << error.what();
        EXPECT_FALSE(error.remedy().empty()) << error.what();
    }
}

} // namespace carom
