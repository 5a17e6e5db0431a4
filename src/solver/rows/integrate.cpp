// Hands bodies to the passes, and those in fields to the kernels one by one.
#include "solver/rows/integrate.hpp"

#include "solver/kernels/motion_kernels.hpp"
#include "solver/rows/body_lanes.hpp"

namespace carom::detail
{

namespace
{

LaneVec<float> lanes_of(Vec2 v) { return {v.x, v.y}; }

MassLanes<float> lanes_of(const BodyMass& mass) { return {lanes_of(mass.inv_mass), mass.inv_inertia}; }

DriveLanes<float> lanes_of(const BodyDrive& drive)
{
    return {lanes_of(drive.force), drive.torque, lanes_of(drive.gravity_scale), drive.linear_damping, drive.angular_damping};
}

} // namespace

void free_accelerations(std::span<const BodyMass> masses, std::span<const BodyDrive> drives, Vec2 gravity, std::span<const Vec2> fields,
                        std::span<Vec2> accelerations)
{
    for (std::size_t i = 1; i < masses.size(); ++i)
    {
        const LaneVec<float> a =
            acceleration_of(lanes_of(masses[i]), lanes_of(drives[i]), lanes_of(fields.empty() ? gravity : gravity + fields[i]));
        accelerations[i] = {a.x, a.y};
    }
}

void integrate_velocities(const BodyPasses& passes, const MovingBodies& bodies, Vec2 gravity, std::span<const Vec2> fields, float h)
{
    static_assert(sizeof(BodyMass) == 4 * sizeof(float) && sizeof(BodyDrive) == 8 * sizeof(float));
    if (fields.empty())
        return passes.integrate_velocities(
            {floats_of(bodies.motions), &bodies.masses.data()->inv_mass.x, &bodies.drives.data()->force.x, bodies.motions.size()},
            {gravity.x, gravity.y, h});
    for (std::size_t i = 1; i < bodies.motions.size(); ++i)
    {
        BodyMotion& motion = bodies.motions[i];
        BodyLanes<float> body = {lanes_of(motion.v), motion.w, {}, {}};
        integrate_velocity(body, lanes_of(bodies.masses[i]), lanes_of(bodies.drives[i]), lanes_of(gravity + fields[i]), h);
        motion.v = {body.v.x, body.v.y};
        motion.w = body.w;
    }
}

Rot turned(Rot q, float turn)
{
    const LaneRot<float> end = turned_by(LaneRot<float>{q.c, q.s}, turn);
    return {end.c, end.s};
}

void integrate_positions(const BodyPasses& passes, std::span<BodyMotion> motions, float h)
{
    passes.integrate_positions(floats_of(motions), motions.size(), h);
}

} // namespace carom::detail
