// What this machine can run, asked of the processor.
#include "solver/isa/dispatch.hpp"

#include "math/usage_error.hpp"

#include <cstdlib>
#include <string>

namespace carom
{

namespace
{

constexpr std::string_view four_lanes =
#if defined(__SSE2__)
    "sse2";
#elif defined(__ARM_NEON)
    "neon";
#elif defined(__wasm_simd128__)
    "wasm";
#else
    "four";
#endif

} // namespace

std::string_view name_of(Simd simd)
{
    switch (simd)
    {
    case Simd::Scalar: return "scalar";
    case Simd::Four: return four_lanes;
    case Simd::Avx2: return "avx2";
    case Simd::Avx512: return "avx512";
    default: return "best";
    }
}

std::optional<Simd> simd_named(std::string_view name)
{
    for (const Simd simd : {Simd::Best, Simd::Scalar, Simd::Four, Simd::Avx2, Simd::Avx512})
        if (name_of(simd) == name) return simd;
    return {};
}

bool is_available(Simd simd)
{
    switch (simd)
    {
#if defined(__x86_64__)
    case Simd::Avx2: return __builtin_cpu_supports("avx2");
    case Simd::Avx512: return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
#else
    case Simd::Avx2:
    case Simd::Avx512: return false;
#endif
    default: return true;
    }
}

/// Sixteen lanes are as fast as eight, take more memory, and make some processors slow down: they are for those who ask.
Simd best_simd() { return is_available(Simd::Avx2) ? Simd::Avx2 : Simd::Four; }

namespace detail
{

Simd chosen_simd(Simd simd, std::string_view function)
{
    const auto require = [&](bool is_good, std::string_view field, std::string_view value)
    {
        if (is_good) return;
        std::string names;
        for (const Simd one : all_simd)
            if (is_available(one)) names += (names.empty() ? "" : ", ") + std::string(name_of(one));
        usage_error(function, field, value, "this machine and build have " + names);
    };
    if (simd != Simd::Best)
    {
        require(is_available(simd), "simd", name_of(simd));
        return simd;
    }
    const char* wanted = std::getenv("CAROM_SIMD");
    if (!wanted || !*wanted) return best_simd();
    const std::optional<Simd> named = simd_named(wanted);
    require(named && is_available(*named), "CAROM_SIMD (in the environment)", wanted);
    return *named == Simd::Best ? best_simd() : *named;
}

const SolverPasses& passes_of(Simd simd)
{
    switch (simd)
    {
#if defined(__x86_64__)
    case Simd::Avx512: return avx512_passes();
    case Simd::Avx2: return avx2_passes();
#endif
    case Simd::Scalar: return scalar_passes();
    default: return four_lane_passes();
    }
}

} // namespace detail
} // namespace carom
