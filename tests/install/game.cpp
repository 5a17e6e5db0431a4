// A user's first program: a ball falls on the ground and stays there.
#include <carom/carom.hpp>

#include <cmath>
#include <cstdio>

int main()
{
    carom::World empty({}); // each of the ways to write a world without special wishes
    carom::World also_empty{};
    carom::World world({.gravity = {0, -9.81f}});
    world.create_body({.type = carom::BodyType::Static}, carom::box(50, 1));
    const carom::BodyId ball = world.create_body({.position = {0, 4}}, carom::circle(0.5f));
    for (int i = 0; i < 180; ++i) world.step(1 / 60.0f);

    const float height = world.body(ball).position().y;
    std::printf("Carom %s: the ball rests at %.3f m\n", CAROM_VERSION, static_cast<double>(height));
    const bool are_empty = empty.body_count() == 0 && also_empty.body_count() == 0;
    return std::abs(height - 1.0f) < 0.01f && are_empty ? 0 : 1;
}
