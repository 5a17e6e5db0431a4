// Profiling: zones, plots, frame marks and memory events of the engine and of a user's own code, in one capture.
//
// The engine is built with one back end, by the CMake option CAROM_PROFILER:
//   none    every macro below leaves no instruction (the default)
//   tracy   events go to a Tracy client, which sends them to a Tracy server
//   chrome  events are recorded in memory between start_trace() and write_trace(), which writes a file for chrome://tracing and
//           https://ui.perfetto.dev
// Who links carom::carom gets the same back end in this header, so a game's zones stand beside the engine's. World::step marks itself as
// the zone "step", each of its stages as a zone with the name that name_of(Stage) gives, and its end as a frame; it plots "bodies",
// "awake bodies", "contacts", "pairs", "islands awake" and "bytes in use".
//
// A name is a string literal, or another text that lives, unchanged, as long as the process. Everything here may be called from any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace carom
{

/// What the engine was built with.
enum class Profiler
{
    None,
    Tracy,
    Chrome
};

/// The back end of the engine that is linked.
Profiler profiler();

/// "none", "tracy", "chrome".
std::string_view name_of(Profiler profiler);

struct TraceOptions
{
    /// Most events that are kept, of all threads together; those that come later are counted as dropped. An event takes 32 bytes, and
    /// memory is taken as it is needed, 64 KiB at a time. A step makes about 40 events. Clamped to 2048 to 2^32.
    std::uint64_t max_events = 8'000'000;
};

/// Whether a request was done, and if not, why.
struct TraceResult
{
    bool is_done = false;
    std::string problem = {};  ///< a sentence that names the remedy; empty when done
    std::uint64_t events = 0;  ///< written to the file
    std::uint64_t dropped = 0; ///< that found no room, or came while the file was being made

    explicit operator bool() const { return is_done; }
};

/// Forgets what was recorded and records from now on. Fails only when the back end is not `chrome`.
TraceResult start_trace(const TraceOptions& options = {});

/// Ends the recording and writes it as JSON in the trace-event format; times are in microseconds from start_trace(). Zones that are open
/// are not in it. When the file can't be written the recording is kept, so that another path may be tried.
/// Fails when the back end is not `chrome`, when nothing was recorded since the last file, or when the file can't be written.
TraceResult write_trace(const std::string& path);

namespace profile
{

/// Why a trace can't be had from this engine.
inline constexpr const char* no_chrome_back_end =
    "this engine records no trace; build it with the CMake preset `trace`, or with -DCAROM_PROFILER=chrome";

/// Where a zone stands. Lives as long as the process.
struct ZoneSite
{
    const char* name;
    const char* function;
    const char* file;
    std::uint32_t line;
    std::uint32_t color = 0; ///< 0xRRGGBB; 0 leaves the choice to the viewer
};

// What the macros call; there only when the back end is not `none`.
std::uint64_t begin_zone(const ZoneSite& site);
void end_zone(const ZoneSite& site, std::uint64_t token); ///< @param token what begin_zone gave
void mark_frame();
void plot(const char* name, double value);
void allocated(const void* pointer, std::size_t bytes, const char* pool);
void freed(const void* pointer, const char* pool);
void name_thread(const char* name);

/// A zone from its construction to its end.
class Zone
{
public:
    explicit Zone(const ZoneSite& site) : site_(site), token_(begin_zone(site)) {}
    Zone(const Zone&) = delete;
    Zone& operator=(const Zone&) = delete;
    ~Zone() { end_zone(site_, token_); }

private:
    const ZoneSite& site_;
    std::uint64_t token_;
};

} // namespace profile

} // namespace carom

// CAROM_ZONE(name)                      the rest of the enclosing block is a zone
// CAROM_FRAME                           a step or a picture is complete
// CAROM_PLOT(name, value)               a number, as it is now; one that is not finite is left out
// CAROM_ALLOCATED(pointer, bytes, pool) a block of memory came from the pool of that name
// CAROM_FREED(pointer, pool)            it was given back; call it before the block can be handed out again
// CAROM_THREAD(name)                    names the calling thread
//
// Each is a statement. Without a back end no argument is evaluated.
#ifdef CAROM_PROFILER_ON
#define CAROM_DETAIL_JOIN2(a, b) a##b
#define CAROM_DETAIL_JOIN(a, b) CAROM_DETAIL_JOIN2(a, b)
#define CAROM_ZONE(name)                                                                                                                   \
    static constexpr ::carom::profile::ZoneSite CAROM_DETAIL_JOIN(carom_zone_site_, __LINE__){name, static_cast<const char*>(__func__),    \
                                                                                              __FILE__, __LINE__};                         \
    const ::carom::profile::Zone CAROM_DETAIL_JOIN(carom_zone_, __LINE__)(CAROM_DETAIL_JOIN(carom_zone_site_, __LINE__))
#define CAROM_FRAME ::carom::profile::mark_frame()
#define CAROM_PLOT(name, value) ::carom::profile::plot(name, static_cast<double>(value))
#define CAROM_ALLOCATED(pointer, bytes, pool) ::carom::profile::allocated(pointer, bytes, pool)
#define CAROM_FREED(pointer, pool) ::carom::profile::freed(pointer, pool)
#define CAROM_THREAD(name) ::carom::profile::name_thread(name)
#else
#define CAROM_ZONE(name) static_cast<void>(sizeof(name))
#define CAROM_FRAME static_cast<void>(0)
#define CAROM_PLOT(name, value) static_cast<void>(sizeof(name) + sizeof(value))
#define CAROM_ALLOCATED(pointer, bytes, pool) static_cast<void>(sizeof(pointer) + sizeof(bytes) + sizeof(pool))
#define CAROM_FREED(pointer, pool) static_cast<void>(sizeof(pointer) + sizeof(pool))
#define CAROM_THREAD(name) static_cast<void>(sizeof(name))
#endif
