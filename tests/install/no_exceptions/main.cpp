// Without exceptions a caller's mistake reaches the handler, with the same text, and good calls work as ever.
#include <carom/carom.hpp>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace
{

void on_usage_error(const carom::UsageError& error)
{
    std::printf("handler: %s\n", error.what());
    const bool names_the_call = std::string_view(error.what()).find("circle") != std::string_view::npos;
    std::exit(names_the_call ? 0 : 1);
}

} // namespace

int main()
{
    carom::World world;
    const carom::BodyId ball = world.create_body({.position = {0, 4}}, carom::circle(0.5f));
    for (int i = 0; i < 60; ++i) world.step(1 / 60.0f);
    if (world.body(ball).position().y > 0) return 1;

    carom::set_usage_error_handler(&on_usage_error);
    carom::circle(-1);
    std::puts("a negative radius reached no handler");
    return 1;
}
