// What is read is what was written, and what is wrong with a file is said where it is.
#include "scene_file/reader.hpp"

#include "scene_file/schema.hpp"
#include "scene_file/writer.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace carom::scene_file
{

namespace
{

std::string problem_of(const std::string& text)
{
    try
    {
        parse_scene_file(text, "scene.json");
    }
    catch (const SceneFileError& error)
    {
        return error.what();
    }
    return "no problem";
}

/// A file of one body with one shape.
std::string with_shape(const std::string& shape) { return R"({"carom_scene": 1, "bodies": [{"shapes": [)" + shape + "]}]}"; }

} // namespace

TEST(SceneFileReader, reads_what_is_given_and_leaves_the_rest_at_its_defaults)
{
    const SceneFile file = parse_scene_file(R"({
"carom_scene": 1, "name": "two", "steps": 90, "world": {"gravity": [0, -10]},
"bodies": [{"type": "static"}, {"position": [0.1, 4], "shapes": [{"circle": {"radius": 0.5}, "material": {"restitution": 0.3}}]}],
"joints": [{"body_a": 0, "body_b": 1, "frame_a": {"p": [1, 2], "q": [0, 1]}, "wheel": {"suspension": null, "motor": {"speed": 3}}}],
"events": [{"step": 4, "set_joints": [{"joint": 0, "motor_speed": -1}]}, {"step": 9, "destroy_bodies": [1]}]})",
                                            "scene.json");
    EXPECT_EQ(file.name, "two");
    EXPECT_EQ(file.steps, 90);
    EXPECT_EQ(file.substeps, 4);
    EXPECT_EQ(file.time_step, 1 / 60.0f);
    EXPECT_EQ(file.world.gravity, (Vec2{0, -10}));
    ASSERT_EQ(file.bodies.size(), 2u);
    EXPECT_EQ(file.bodies[0].def.type, BodyType::Static);
    EXPECT_EQ(file.bodies[1].def.type, BodyType::Dynamic);
    EXPECT_EQ(file.bodies[1].def.position, (Vec2{0.1f, 4}));
    ASSERT_EQ(file.bodies[1].shapes.size(), 1u);
    EXPECT_EQ(std::get<Circle>(file.bodies[1].shapes[0].geometry).radius, 0.5f);
    EXPECT_EQ(file.bodies[1].shapes[0].def.material, (Material{.restitution = 0.3f}));
    ASSERT_EQ(file.joints.size(), 1u);
    EXPECT_EQ(file.joints[0].body_a, 0);
    EXPECT_EQ(file.joints[0].def.frame_a, (Transform{{1, 2}, {0, 1}}));
    const auto& wheel = std::get<WheelJoint>(file.joints[0].spec);
    EXPECT_FALSE(wheel.suspension);
    EXPECT_EQ(wheel.motor, (Motor{.speed = 3}));
    ASSERT_EQ(file.events.size(), 2u);
    EXPECT_EQ(file.events[0].set_joints[0].motor_speed, -1);
    EXPECT_EQ(file.events[1].destroy_bodies, std::vector<int>{1});
    EXPECT_EQ(file.needs, (std::vector<std::string>{"events", "wheel_joints"}));
}

TEST(SceneFileReader, names_line_and_column_of_a_syntax_error)
{
    EXPECT_EQ(problem_of("{\"carom_scene\": 1,\n\"steps\": nan}").substr(0, 40), "scene.json:2:11: syntax error while pars");
    EXPECT_EQ(problem_of("{").substr(0, 17), "scene.json:1:2: s");
    EXPECT_EQ(problem_of(" "), "scene.json: the file is empty; write {\"carom_scene\": 1, ...}");
    EXPECT_EQ(problem_of("[]"), "scene.json:1:1: the file is a list; write {\"carom_scene\": 1, ...}");
}

TEST(SceneFileReader, names_the_place_the_value_and_what_is_expected)
{
    EXPECT_EQ(problem_of(with_shape(R"({"circle": {"radius": -1}})")),
              "scene.json:1:65: bodies[0].shapes[0].circle.radius is -1; give a number > 0 [m]");
    EXPECT_EQ(problem_of(with_shape(R"({"circle": {"radius": "big"}})")),
              "scene.json:1:65: bodies[0].shapes[0].circle.radius is \"big\"; give a number > 0 and at most 1000000 [m]");
    EXPECT_EQ(problem_of(with_shape(R"({"circle": {"radios": 1, "radius": 1}})")),
              "scene.json:1:55: bodies[0].shapes[0].circle has an unknown field \"radios\"; did you mean radius?");
    EXPECT_EQ(problem_of(with_shape(R"({"circle": {}})")), "scene.json:1:54: bodies[0].shapes[0].circle has no field \"radius\"; add it");
    EXPECT_EQ(problem_of(with_shape(R"({"circle": {"radius": 1, "center": [0, 1e39]}})")),
              "scene.json:1:82: bodies[0].shapes[0].circle.center[1] is 1e39; give a number from -1000000 to 1000000 [m]");
    EXPECT_EQ(problem_of(with_shape("{}")),
              "scene.json:1:43: bodies[0].shapes[0] has no type; add one of circle, capsule, segment, polygon");
    EXPECT_EQ(problem_of(with_shape(R"({"circle": {"radius": 1}, "segment": {"p1": [0, 0], "p2": [1, 0]}})")),
              "scene.json:1:69: bodies[0].shapes[0] has both \"circle\" and \"segment\"; give one of them");
    EXPECT_EQ(problem_of(with_shape(R"({"segment": {"p1": [1, 0], "p2": [1, 0]}})")),
              "scene.json:1:43: bodies[0].shapes[0].segment.p2 is (1, 0); give ends that are at least 1 mm apart");
    EXPECT_EQ(problem_of(with_shape(R"({"polygon": {"vertices": [[0, 0], [1, 1], [1, 0]]}})")),
              "scene.json:1:55: bodies[0].shapes[0].polygon.vertices[2] is (1, 0); "
              "give the corners of a convex polygon counter-clockwise, or use convex_hull()");
    EXPECT_EQ(problem_of(R"({"carom_scene": 2})"),
              "scene.json:1:17: carom_scene is 2; give 1, the version of the format that this program reads");
    EXPECT_EQ(problem_of("{}"), "scene.json:1:1: the file has no field \"carom_scene\"; add it");
    EXPECT_EQ(problem_of(R"({"carom_scene": 1, "steps": 0.5})"), "scene.json:1:29: steps is 0.5; give a whole number from 1 to 1e+07");
    EXPECT_EQ(problem_of(R"({"carom_scene": 1, "bodies": [{"type": "dynamo"}]})"),
              "scene.json:1:40: bodies[0].type is \"dynamo\"; it is none of the words; did you mean dynamic?");
    EXPECT_EQ(problem_of(R"({"carom_scene": 1, "bodies": [{}, 5]})"), "scene.json:1:35: bodies[1] is 5; give an object in {}");
    EXPECT_EQ(problem_of(R"({"carom_scene": 1, "bodies": 5})"), "scene.json:1:30: bodies is 5; give a list in []");
    EXPECT_EQ(problem_of(R"({"carom_scene": 1, "bodies": [{"position": [1]}]})"),
              "scene.json:1:44: bodies[0].position is [1]; give two numbers in [] [m]");
}

TEST(SceneFileReader, refuses_fields_that_appear_twice)
{
    EXPECT_EQ(problem_of(R"({"carom_scene": 1, "bodies": [{}, {"angle": 1, "angle": 1}]})"),
              "scene.json:1:48: bodies[1].angle appears twice; give it once");
    EXPECT_EQ(problem_of(R"({"carom_scene": 1, "carom_scene": 1})"), "scene.json:1:20: carom_scene appears twice; give it once");
}

TEST(SceneFileReader, refuses_numbers_that_name_nothing)
{
    const std::string start = R"({"carom_scene": 1, "bodies": [{}, {}], )";
    EXPECT_EQ(problem_of(start + R"("joints": [{"body_b": 2, "weld": {}}]})"),
              "scene.json:1:51: joints[0].body_b is 2; there are 2 bodies at that point, numbered from 0");
    EXPECT_EQ(problem_of(start + R"("joints": [{"body_a": 1, "body_b": 1, "weld": {}}]})"),
              "scene.json:1:51: joints[0].body_b is the same as body_a; give two bodies, or leave out body_a for the world");
    EXPECT_EQ(problem_of(start + R"("events": [{"step": 1, "destroy_bodies": [0, 0]}]})"),
              "scene.json:1:51: events[0].destroy_bodies[1] is 0; that body was destroyed before");
    EXPECT_EQ(problem_of(start + R"("events": [{"step": 2}, {"step": 1}]})"),
              "scene.json:1:64: events[1].step is 1; give events by step: the one before is at 2");
    const std::string joined = start + R"("joints": [{"body_a": 0, "body_b": 1, "weld": {}}], )";
    EXPECT_EQ(problem_of(joined + R"("events": [{"step": 1, "destroy_bodies": [0]}, {"step": 1, "destroy_joints": [0]}]})"),
              "scene.json:1:139: events[1].destroy_joints[0] is 0; that joint was destroyed before");
    EXPECT_EQ(problem_of(joined + R"("events": [{"step": 1, "set_joints": [{"joint": 0, "motor_speed": 1}]}]})"),
              "scene.json:1:130: events[0].set_joints[0].motor_speed does not fit; joint 0 is a weld joint, which has no motor");
    EXPECT_EQ(problem_of(start + R"("needs": ["rais"]})"), "scene.json:1:1: needs names \"rais\", which is no feature; did you mean rays?");
    EXPECT_EQ(problem_of(start + R"("needs": ["rays"], "events": [{"step": 0}]})"),
              "scene.json:1:1: needs leaves out \"events\"; add it, or leave out needs as a whole");
}

TEST(SceneFileReader, refuses_what_is_nested_too_deeply)
{
    const std::string deep = R"({"carom_scene": 1, "bodies": )" + std::string(100000, '[') + std::string(100000, ']') + "}";
    EXPECT_EQ(problem_of(deep), "scene.json:1:31: bodies[0] is a list; give an object in {}");
}

TEST(SceneFileReader, says_when_a_file_can_not_be_read)
{
    EXPECT_THROW(read_scene_file("/nowhere/scene.json"), SceneFileError);
    EXPECT_THROW(read_scene_file("/tmp"), SceneFileError);
}

TEST(SceneFileSchema, is_the_one_in_the_documents)
{
    std::ifstream file(CAROM_SOURCE_DIR "/docs/scene.schema.json");
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_EQ(text.str(), scene_file_schema()) << "run: carom export --schema > docs/scene.schema.json";
}

} // namespace carom::scene_file
