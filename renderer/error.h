// SPDX-License-Identifier: Apache-2.0
// The one error type of the library. Thrown for what the user or the machine did wrong (never for our own bugs:
// those are asserts); the program maps its kind to an exit code in one place.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace umbrage {

enum class ErrorKind {
    Usage,   // the command line is wrong
    Input,   // the sequence or a scene is wrong
    Device,  // no usable EGL/GL
    Output,  // a result could not be written
};

class Error : public std::runtime_error {
public:
    /// @param where  the place: "file:line:column", "file: /json/pointer", or a path; may be empty
    /// @param message  what is wrong, as a sentence without a full stop
    /// @param hint  what to do about it; may be empty
    Error(ErrorKind kind, const std::string& where, const std::string& message, const std::string& hint = {})
        : std::runtime_error((where.empty() ? "" : where + ": ") + message + (hint.empty() ? "" : " (" + hint + ")")),
          kind_(kind),
          where_(where),
          message_(message),
          hint_(hint) {}

    ErrorKind kind() const { return kind_; }
    const std::string& where() const { return where_; }
    const std::string& message() const { return message_; }
    const std::string& hint() const { return hint_; }

private:
    ErrorKind kind_;
    std::string where_, message_, hint_;
};

}  // namespace umbrage
