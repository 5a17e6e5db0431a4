#include "solver/rows/softness.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace carom::detail
{
namespace
{

/// A mass on a soft row, substep by substep, must move like a damped oscillator: x'' + 2 zeta omega x' + omega^2 x = 0.
TEST(Softness, MovesLikeTheSpringAndTheDamperThatItStandsFor)
{
    const float h = 1e-4f;
    for (const float zeta : {0.2f, 0.5f, 0.9f})
    {
        const float hertz = 2;
        const Softness soft = make_softness(hertz, zeta, h);
        double x = 1;
        double v = 0;
        double lambda = 0; // of unit mass
        for (int i = 0; i < 2000; ++i)
        {
            v += lambda; // warm start
            const double change = -double{soft.mass_scale} * (v + double{soft.bias_rate} * x) - double{soft.impulse_scale} * lambda;
            lambda += change;
            v += change;
            x += h * v;
        }
        const double omega = 2 * 3.14159265358979 * hertz;
        const double damped = omega * std::sqrt(1 - zeta * zeta);
        const double t = 2000 * h;
        const double expected = std::exp(-zeta * omega * t) * (std::cos(damped * t) + zeta * omega / damped * std::sin(damped * t));
        EXPECT_NEAR(x, expected, 0.01) << zeta;
    }
}

TEST(Softness, SharesAddUpAndStayWithinBounds)
{
    for (const float hertz : {0.01f, 1.0f, 30.0f, 1e6f})
        for (const float zeta : {0.0f, 1.0f, 10.0f, 1e6f})
            for (const float h : {1e-8f, 1e-3f, 1.0f})
            {
                const Softness soft = make_softness(hertz, zeta, h);
                EXPECT_NEAR(soft.mass_scale + soft.impulse_scale, 1, 1e-6);
                EXPECT_GE(soft.mass_scale, 0);
                EXPECT_LE(soft.bias_rate * h, 1.000001f) << "never undoes more than the whole error in a substep";
            }
}

TEST(ContactConstants, ImpulsesScaleWithTheSubstep)
{
    EXPECT_EQ(make_contact_constants({}, 0.04f, 0.01f, 0.02f).warm_scale, 0.5f);
    EXPECT_EQ(make_contact_constants({}, 0.04f, 0.01f, 0).warm_scale, 0) << "no step before";
}

TEST(ContactConstants, HertzIsLimitedByTheSubstepRate)
{
    const float h = 0.02f; // an eighth of 50 Hz is 6.25 Hz
    const ContactConstants limited = make_contact_constants({.contact_hertz = 30}, h, h, h);
    EXPECT_FLOAT_EQ(limited.between_dynamic.bias_rate, make_softness(6.25f, 10, h).bias_rate);
    EXPECT_FLOAT_EQ(limited.with_static.bias_rate, make_softness(12.5f, 10, h).bias_rate);
}

} // namespace
} // namespace carom::detail
