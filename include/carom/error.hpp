// What happens on a caller's mistake: an exception that names the function, the field, the value and the remedy.
#pragma once

#include <stdexcept>
#include <string>

namespace carom
{

/// A mistake of the caller's: a stale id, a value out of range, an edit during a step. The call changed nothing.
/// what() reads "create_body: position.x is nan; give a finite position".
class UsageError : public std::logic_error
{
public:
    UsageError(std::string function, std::string field, std::string value, std::string remedy);

    const std::string& function() const { return function_; }
    const std::string& field() const { return field_; }
    const std::string& value() const { return value_; }
    const std::string& remedy() const { return remedy_; }

private:
    std::string function_;
    std::string field_;
    std::string value_;
    std::string remedy_;
};

/// Called instead of throwing when the engine is built without exceptions. It must not return; when it does, the
/// process is aborted. The default prints the error to the standard error stream.
using UsageErrorHandler = void (*)(const UsageError&);

/// Replaces the handler for every world of the process and returns the one before; null restores the default.
/// Has no effect on an engine that is built with exceptions. May be called from any thread.
UsageErrorHandler set_usage_error_handler(UsageErrorHandler handler);

} // namespace carom
