// What this machine can run, asked of the processor.
#include "solver/isa/dispatch.hpp"

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
