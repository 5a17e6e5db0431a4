// Ragdolls: many of them for a while, or a few down some stairs.
#include "lab/field_scenes/makers.hpp"

#include <array>
#include <utility>

namespace carom::lab
{

namespace
{

/// A limb is a capsule between two points of a doll that stands upright with its hips at the origin.
struct Limb
{
    Vec2 from;
    Vec2 to;
    float radius;
    int part_of; ///< the limb that it hangs on, -1 for none
    Vec2 joint;  ///< where
    Range bend;  ///< [rad]
};

//   1 head
//   0 torso --- 3, 4 and 5, 6 arms
//   2 hips
//   7, 8 and 9, 10 legs
constexpr std::array limbs = {
    Limb{{0, 0.20f}, {0, 0.40f}, 0.11f, -1, {}, {}},
    Limb{{0, 0.60f}, {0, 0.68f}, 0.09f, 0, {0, 0.52f}, {-0.5f, 0.5f}},
    Limb{{0, -0.02f}, {0, 0.04f}, 0.11f, 0, {0, 0.12f}, {-0.4f, 0.6f}},
    Limb{{0, 0.38f}, {0, 0.18f}, 0.05f, 0, {0, 0.42f}, {-1.5f, 2.5f}},
    Limb{{0, 0.08f}, {0, -0.12f}, 0.04f, 3, {0, 0.13f}, {0, 2.4f}},
    Limb{{0, 0.38f}, {0, 0.18f}, 0.05f, 0, {0, 0.42f}, {-1.5f, 2.5f}},
    Limb{{0, 0.08f}, {0, -0.12f}, 0.04f, 5, {0, 0.13f}, {0, 2.4f}},
    Limb{{0, -0.12f}, {0, -0.38f}, 0.07f, 2, {0, -0.08f}, {-0.4f, 1.8f}},
    Limb{{0, -0.50f}, {0, -0.78f}, 0.05f, 7, {0, -0.44f}, {-2.2f, 0}},
    Limb{{0, -0.12f}, {0, -0.38f}, 0.07f, 2, {0, -0.08f}, {-0.4f, 1.8f}},
    Limb{{0, -0.50f}, {0, -0.78f}, 0.05f, 9, {0, -0.44f}, {-2.2f, 0}},
};
constexpr int limb_count = static_cast<int>(limbs.size());

/// Where the parts of dolls go: the lists of a file or of an event, and the number that the next body gets.
struct DollSink
{
    std::vector<FileBody>& bodies;
    std::vector<FileJoint>& joints;
    int next_body;
    int next_group;
};

/// @param at the hips
void add_doll(DollSink& sink, Vec2 at, float angle)
{
    constexpr float friction_torque = 0.05f; // of a joint [N m]: limp, but it comes to rest
    const ShapeDef flesh{.material = {.friction = 0.3f}, .filter = {.group = -sink.next_group++}};
    const int first = sink.next_body;
    for (int i = 0; i < limb_count; ++i)
    {
        const Limb& limb = limbs[static_cast<std::size_t>(i)];
        sink.bodies.push_back(body_of({.position = at, .angle = angle}, capsule(limb.from, limb.to, limb.radius), flesh));
        if (limb.part_of < 0) continue;
        sink.joints.push_back({.body_a = first + limb.part_of,
                               .body_b = first + i,
                               .def = {.frame_a = {limb.joint, {}}, .frame_b = {limb.joint, {}}},
                               .spec = RevoluteJoint{.limit = limb.bend, .motor = Motor{0, friction_torque}}});
    }
    sink.next_body += limb_count;
}

} // namespace

/// Every eighth step a column of 5 groups of 5 dolls comes; when all columns are there, the oldest goes for it.
SceneFile rain(const FieldSetup& setup)
{
    constexpr int groups = 5;
    constexpr int dolls = 5; // in a group
    constexpr int steps_between = 8;
    constexpr int steps = 1000;
    constexpr float spacing = 1.1f; // of the dolls of a group [m]
    const int columns = setup.size;
    const float column_width = spacing * dolls + 1;
    const float width = column_width * static_cast<float>(columns);

    SceneFile file;
    FileBody ground = ground_body();
    const int stones = static_cast<int>(width) + 60;
    for (int i = 0; i < stones; ++i)
        ground.shapes.push_back({offset_box(1, 2, {static_cast<float>(i) - 0.5f * static_cast<float>(stones), i % 7 == 0 ? -0.8f : -1})});
    add(file, ground);

    std::vector<int> first_of_column(static_cast<std::size_t>(columns), -1);
    scenes::Random random(setup.seed, 1);
    int next_body = 1;
    int next_group = 1;
    for (int turn = 0; turn * steps_between < steps; ++turn)
    {
        const int column = turn % columns;
        FileEvent event{.step = turn * steps_between};
        int& first = first_of_column[static_cast<std::size_t>(column)];
        for (int i = 0; first >= 0 && i < groups * dolls * limb_count; ++i) event.destroy_bodies.push_back(first + i);
        first = next_body;
        DollSink sink{event.create_bodies, event.create_joints, next_body, next_group};
        for (int i = 0; i < groups * dolls; ++i)
        {
            const float across =
                column_width * static_cast<float>(column) - 0.5f * width + spacing * (static_cast<float>(i % dolls) + 0.8f);
            const float angle = random.uniform(-0.3f, 0.3f);
            add_doll(sink, {across, 12 + 2.2f * static_cast<float>(i / dolls)}, angle);
        }
        next_body = sink.next_body;
        next_group = sink.next_group;
        file.events.push_back(std::move(event));
    }
    file.view = FileView{{-0.25f * width, 0.11f * width}, 0.28f * width + 4};
    return file;
}

SceneFile ragdolls(const FieldSetup& setup)
{
    SceneFile file;
    FileBody ground = open_box(18, 30);
    constexpr int steps = 12;
    for (int i = 0; i < steps; ++i)
    {
        const float height = 0.5f * static_cast<float>(steps - i);
        ground.shapes.push_back({offset_box(1.2f, height, {-17.4f + 1.2f * static_cast<float>(i), 0.5f * height})});
    }
    add(file, ground);
    scenes::Random random(setup.seed, 1);
    DollSink sink{file.bodies, file.joints, 1, 1};
    for (int i = 0; i < setup.size; ++i)
    {
        const Vec2 place{-16 + 2 * static_cast<float>(i % 8), 8 + 2 * static_cast<float>(i / 8)};
        const float angle = random.uniform(-1, 1);
        add_doll(sink, place, angle);
    }
    file.view = FileView{{-6, 5}, 14};
    return file;
}

} // namespace carom::lab
