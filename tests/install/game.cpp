// A user's first program: a ball falls on the ground and stays there.
#include <carom/carom.hpp>

#include <cmath>
#include <cstdio>

int main()
{
    carom::World world({.gravity = {0, -9.81f}});
    world.create_body({.type = carom::BodyType::Static}, carom::box(50, 1));
    const carom::BodyId ball = world.create_body({.position = {0, 4}}, carom::circle(0.5f));
    for (int i = 0; i < 180; ++i) world.step(1 / 60.0f);

    const float height = world.body(ball).position().y;
    std::printf("Carom %s: the ball rests at %.3f m\n", CAROM_VERSION, static_cast<double>(height));
    return std::abs(height - 1.0f) < 0.01f ? 0 : 1;
}
