// Soft constraints: a row that gives way like a spring and a damper, stable at any stiffness.
#pragma once

#include "geometry/tolerances.hpp"
#include "solver/kernels/joint_row.hpp"

#include <carom/math.hpp>
#include <carom/world.hpp>

#include <algorithm>

namespace carom::detail
{

/// How a row undoes its error C over one substep:
///   lambda = -mass_scale m (Jv + bias_rate C) - impulse_scale lambda_before
/// With omega = 2 pi hertz, damping ratio zeta and substep h, implicit integration of a spring and a damper gives
///   bias_rate = omega / (2 zeta + h omega),  a = h omega (2 zeta + h omega),  mass_scale = a / (1 + a),  impulse_scale = 1 / (1 + a)
/// @source E. Catto, "Soft Constraints", GDC 2011
struct Softness
{
    float bias_rate = 0;     ///< [1/s]
    float mass_scale = 1;    ///< 1 is rigid
    float impulse_scale = 0; ///< 0 is rigid
};

/// @param hertz natural frequency [1/s], > 0
/// @param h     substep [s]
inline Softness make_softness(float hertz, float damping_ratio, float h)
{
    const float omega = 2 * pi * hertz;
    const float damping = 2 * damping_ratio + h * omega;
    const float a = h * omega * damping;
    return {.bias_rate = omega / damping, .mass_scale = a / (1 + a), .impulse_scale = 1 / (1 + a)};
}

inline SpringRow<float> make_spring(float hertz, float damping_ratio, float h)
{
    const float omega = 2 * pi * hertz;
    const float theta = std::clamp(2 * omega * h - 1, 0.0f, 1.0f);
    const float s = h * (theta * h * omega * omega + 2 * damping_ratio * omega);
    return {.damping = s / (1 + s), .push = h * omega * omega / (1 + s), .impulse_scale = 1 / (1 + s)};
}

/// Whether a drive that asks for a speed moves anything: a blocked one does not keep its bodies awake. Both in the same unit.
inline bool is_at_work(float speed, float asked)
{
    constexpr float least_share = 0.01f;
    return asked != 0 && speed * asked >= least_share * asked * asked;
}

/// What the contact rows of a step share.
struct ContactConstants
{
    float dt = 0;                    ///< step [s]
    float h = 0;                     ///< substep [s]
    float inv_h = 0;                 ///< [1/s]
    float push_out_speed = 0;        ///< [m/s]
    float restitution_threshold = 0; ///< [m/s]
    float carry_share = 0;           ///< see carried_impulse: weight of this step's load in its running mean
    float calm_share = 0;            ///< the same between bodies at rest
    float settled_within = 0;        ///< Tolerances::settled_within [m]
    float warm_scale = 1;            ///< this substep over the one before: impulses are forces times substeps
    Softness between_dynamic;
    Softness with_static; ///< twice as stiff: the ground does not give way
};

/// How much of a lasting load the rest length of a contact's spring is corrected for. At 1 nothing would sag, and two walls that squeeze a
/// body would push harder without end; at 0.8 all sags are a fifth of the plain spring's.
inline constexpr float carried_part = 0.8f;

/// How fast that correction follows the load [1/s]: slower than a tower sways, or it would drive the swaying. stacking_test breaks.
inline constexpr float carry_rate = 1.2f;

/// The same between bodies at rest that are to fall asleep once their contacts have settled [1/s]: a tower of 20 boxes sleeps after 1.6 s, not 3.6. A
/// pyramid that must not sleep would sway twice as far in 8 s.
inline constexpr float calm_rate = 6;

/// A spring is integrated well up to an eighth of the substep rate; stiffer ones ring [1/s].
inline float contact_stiffness(const SolverTuning& tuning, float h) { return std::min(tuning.contact_hertz, 0.125f / h); }

/// Whether contacts get less than half of the stiffness that they were tuned for, a little less so that no rounding shows: piles of
/// ten boxes then begin to tip over. Tests: step_length_test.
inline bool is_too_soft(const SolverTuning& tuning, float h) { return contact_stiffness(tuning, h) < 0.499f * tuning.contact_hertz; }

/// Factor from the last step's impulses to the first guess of this step's; 0 for no guess.
/// @param h        substep [s]
/// @param h_before substep of the last step [s]; 0 when there was none
inline float warm_scale_of(const SolverTuning& tuning, float h, float h_before)
{
    return tuning.warm_starting && h_before > 0 ? h / h_before : 0.0f;
}

/// @param dt       step [s]
/// @param h        substep [s]
/// @param h_before substep of the last step [s]; 0 when there was none
/// @param may_sleep whether the world lets bodies fall asleep
inline ContactConstants make_contact_constants(const SolverTuning& tuning, float dt, float h, float h_before,
                                               const Tolerances& tolerances = {}, bool may_sleep = true)
{
    const float hertz = contact_stiffness(tuning, h);
    const auto share_of = [dt](float rate) { return rate * dt / (1 + rate * dt); };
    return {.dt = dt,
            .h = h,
            .inv_h = 1 / h,
            .push_out_speed = tuning.push_out_speed * tolerances.length_unit,
            .restitution_threshold = tuning.restitution_threshold * tolerances.length_unit,
            .carry_share = share_of(carry_rate),
            .calm_share = share_of(may_sleep ? calm_rate : carry_rate),
            .settled_within = tolerances.settled_within,
            .warm_scale = warm_scale_of(tuning, h, h_before),
            .between_dynamic = make_softness(hertz, tuning.contact_damping_ratio, h),
            .with_static = make_softness(2 * hertz, tuning.contact_damping_ratio, h)};
}

/// What the joint rows of a step share.
struct JointStepConstants
{
    float h = 0;           ///< substep [s]
    float inv_h = 0;       ///< [1/s]
    float warm_scale = 1;  ///< as for contacts
    float bias_rate = 0;   ///< at which rows that hold something undo their error [1/s]
    Softness single;       ///< of such rows that are solved one by one
    float length_unit = 1; ///< of the world [m]
};

/// @param h        substep [s]
/// @param h_before substep of the last step [s]; 0 when there was none
inline JointStepConstants make_joint_constants(const SolverTuning& tuning, float h, float h_before, const Tolerances& tolerances = {})
{
    const Softness rigid = make_softness(std::min(tuning.joint_hertz, 0.25f / h), tuning.joint_damping_ratio, h);
    // Stiffer: a net sags less. Still stiffer ones shake a net of redundant pins apart (RedundantJoints.a_net_of_pins_hangs, from 0.5 / h and ratio 1 on).
    const Softness single = make_softness(std::min(1.8f * tuning.joint_hertz, 0.45f / h), 0.25f * tuning.joint_damping_ratio, h);
    return {.h = h,
            .inv_h = 1 / h,
            .warm_scale = warm_scale_of(tuning, h, h_before),
            .bias_rate = rigid.bias_rate,
            .single = single,
            .length_unit = tolerances.length_unit};
}

} // namespace carom::detail
