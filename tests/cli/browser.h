// SPDX-License-Identifier: Apache-2.0
// Drives a headless Chromium over its DevTools pipe: opens a page, asks it things, moves the pointer, presses keys.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace umbrage::cli {

class Browser {
public:
    using Json = nlohmann::json;

    /// The Chromium of this machine; empty where there is none.
    static std::filesystem::path program();

    /// @param profile  a folder of its own
    /// @throws std::runtime_error if it does not start
    explicit Browser(const std::filesystem::path& profile);
    ~Browser();
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;

    /// Waits until the page is loaded.
    void open(const std::string& url);

    /// The value of an expression. @throws std::runtime_error with what it threw
    Json evaluate(const std::string& expression);

    /// A command of the DevTools protocol to the page.
    Json call(const std::string& method, const Json& parameters = Json::object());

    void movePointer(double x, double y);
    void click(double x, double y);
    /// @param key  as KeyboardEvent.key has it
    void press(const std::string& key);

    /// Exceptions, messages of the console and of the log (refused connections among them).
    const std::vector<std::string>& complaints() const { return complaints_; }
    /// URLs of everything that was asked for.
    const std::vector<std::string>& requests() const { return requests_; }

private:
    Json send(const std::string& method, const Json& parameters, const std::string& session);
    Json receive();
    void note(const Json& event);

    pid_t process_ = -1;
    int toBrowser_ = -1, fromBrowser_ = -1;
    int lastId_ = 0;
    bool loaded_ = false;
    std::string session_, buffered_;
    std::vector<std::string> complaints_, requests_;
};

/// Fails the test where the page complained, or asked for anything that is not in its file.
void expectQuietAndOffline(const Browser& browser);

}  // namespace umbrage::cli
