// A game whose zones stand in the same capture as the engine's.
#include <carom/carom.hpp>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

int main()
{
    if (!carom::start_trace()) return 1;
    carom::World world({.gravity = {0, -9.81f}});
    world.create_body({.position = {0, 4}}, carom::circle(0.5f));
    for (int i = 0; i < 10; ++i)
    {
        CAROM_ZONE("update game");
        world.step(1 / 60.0f);
    }
    const std::string path = "game_trace.json";
    const carom::TraceResult result = carom::write_trace(path);
    if (!result) return std::printf("%s\n", result.problem.c_str()), 1;

    std::ifstream file(path);
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    for (const char* zone : {"\"update game\"", "\"find pairs\""})
        if (text.find(zone) == std::string::npos) return std::printf("no zone %s\n", zone), 1;
    return 0;
}
