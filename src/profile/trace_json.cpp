// Formats events one a line, through a buffer of fixed size.
#include "profile/trace_json.hpp"

#include <carom/version.hpp>

#include <array>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>

namespace carom::profile
{

namespace
{

/// Text on its way to a file. The first failure is kept.
class Output
{
public:
    explicit Output(const std::string& path) : file_(std::fopen(path.c_str(), "wb")) { note_failure(file_ == nullptr); }
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;
    ~Output() { close(); }

    Output& operator<<(std::string_view text)
    {
        if (file_) note_failure(std::fwrite(text.data(), 1, text.size(), file_) != text.size());
        return *this;
    }
    template <class Number>
    Output& number(Number value)
    {
        std::array<char, 32> digits;
        const std::to_chars_result end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
        return *this << std::string_view(digits.data(), static_cast<std::size_t>(end.ptr - digits.data()));
    }
    /// Nanoseconds >= 0 as microseconds with three decimals.
    Output& microseconds(std::int64_t ns)
    {
        number(ns / 1000);
        const std::array<char, 4> decimals{'.', digit(ns / 100), digit(ns / 10), digit(ns)};
        return *this << std::string_view(decimals.data(), decimals.size());
    }
    Output& quoted(std::string_view text);

    std::string close()
    {
        if (file_) note_failure(std::fclose(file_) != 0);
        file_ = nullptr;
        return failure_;
    }

private:
    static char digit(std::int64_t n) { return static_cast<char>('0' + n % 10); }
    void note_failure(bool has_failed)
    {
        if (has_failed && failure_.empty()) failure_ = std::strerror(errno);
    }

    std::FILE* file_;
    std::string failure_;
};

Output& Output::quoted(std::string_view text)
{
    *this << "\"";
    for (const char c : text)
    {
        const auto code = static_cast<unsigned char>(c);
        const std::array<char, 6> escaped{'\\', 'u', '0', '0', "0123456789abcdef"[code >> 4], "0123456789abcdef"[code & 15]};
        const bool is_plain = code >= 0x20 && c != '"' && c != '\\';
        *this << (is_plain ? std::string_view(&c, 1) : std::string_view(escaped.data(), escaped.size()));
    }
    return *this << "\"";
}

/// `{"ph":"X","pid":1,"tid":1,"name":"solve","ts":12.345`: what all events have.
void begin_event(Output& out, const char* phase, const TraceEvent& event, std::uint32_t thread, std::int64_t start_ns,
                 std::string_view before_name = {})
{
    out << ",\n{\"ph\":\"" << phase << "\",\"pid\":1,\"tid\":";
    out.number(thread) << ",\"name\":";
    out.quoted(std::string(before_name) + event.name) << ",\"ts\":";
    out.microseconds(event.start_ns - start_ns);
}

void write_event(Output& out, const TraceEvent& event, std::uint32_t thread, std::int64_t start_ns)
{
    switch (event.kind)
    {
    case EventKind::Zone:
        begin_event(out, "X", event, thread, start_ns);
        (out << ",\"dur\":").microseconds(static_cast<std::int64_t>(event.value)) << "}";
        return;
    case EventKind::Frame:
        begin_event(out, "i", event, thread, start_ns);
        out << ",\"s\":\"p\"}";
        return;
    case EventKind::Plot:
        begin_event(out, "C", event, thread, start_ns);
        (out << ",\"args\":{\"value\":").number(std::bit_cast<double>(event.value)) << "}}";
        return;
    case EventKind::Memory: // a viewer would take a plot of the same name for the same counter
        begin_event(out, "C", event, thread, start_ns, "memory: ");
        (out << ",\"cat\":\"memory\",\"args\":{\"bytes\":").number(event.value) << "}}";
        return;
    }
}

void write_thread_name(Output& out, const ThreadEvents& thread)
{
    out << ",\n{\"ph\":\"M\",\"pid\":1,\"tid\":";
    out.number(thread.number) << ",\"name\":\"thread_name\",\"args\":{\"name\":";
    out.quoted(thread.name ? std::string(thread.name) : "thread " + std::to_string(thread.number)) << "}}";
}

} // namespace

std::string write_trace_json(const std::string& path, std::span<const ThreadEvents> threads, std::int64_t start_ns, std::uint64_t dropped)
{
    Output out(path);
    out << "{\"displayTimeUnit\":\"ns\",\"otherData\":{\"version\":\"carom " CAROM_VERSION "\",\"dropped_events\":";
    out.number(dropped) << "},\"traceEvents\":[\n";
    out << R"({"ph":"M","pid":1,"name":"process_name","args":{"name":"carom"}})";
    for (const ThreadEvents& thread : threads)
    {
        write_thread_name(out, thread);
        thread.events.for_each([&](const TraceEvent& event)
        {
            if (event.start_ns >= start_ns) write_event(out, event, thread.number, start_ns);
        });
    }
    out << "\n]}\n";
    return out.close();
}

} // namespace carom::profile
