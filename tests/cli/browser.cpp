// SPDX-License-Identifier: Apache-2.0
#include "browser.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace umbrage::cli {
namespace {

constexpr int kLimitMilliseconds = 30000;

}  // namespace

std::filesystem::path Browser::program() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const std::filesystem::path file = std::filesystem::path(folder) / "chromium";
        if (::access(file.c_str(), X_OK) == 0) return file;
    }
    return {};
}

Browser::Browser(const std::filesystem::path& profile) {
    std::array<int, 2> commands{}, answers{};
    if (::pipe2(commands.data(), O_CLOEXEC) != 0 || ::pipe2(answers.data(), O_CLOEXEC) != 0) {
        throw std::runtime_error("no pipe");
    }
    const std::string file = program().string(), folder = "--user-data-dir=" + profile.string();
    process_ = ::fork();
    if (process_ == 0) {
        ::setpgid(0, 0);
        // Chromium reads commands from 3 and answers on 4; these may be pipe ends themselves.
        const int in = ::fcntl(commands[0], F_DUPFD, 10), out = ::fcntl(answers[1], F_DUPFD, 10);
        const int nowhere = ::open("/dev/null", O_RDWR);
        ::dup2(in, 3);
        ::dup2(out, 4);
        for (const int fd : {0, 1, 2}) ::dup2(nowhere, fd);
        ::execl(file.c_str(), file.c_str(), "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                "--no-first-run", "--window-size=1400,1000", "--remote-debugging-pipe", folder.c_str(),
                static_cast<char*>(nullptr));
        ::_exit(127);
    }
    ::close(commands[0]);
    ::close(answers[1]);
    toBrowser_ = commands[1];
    fromBrowser_ = answers[0];
    const Json target = send("Target.createTarget", {{"url", "about:blank"}}, "");
    const Json attached = send("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}}, "");
    session_ = attached["sessionId"];
    for (const char* domain : {"Page", "Runtime", "Log", "Network"}) call(std::string(domain) + ".enable");
}

Browser::~Browser() {
    ::close(toBrowser_);
    ::close(fromBrowser_);
    if (process_ > 0) {
        ::kill(-process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
}

Browser::Json Browser::receive() {
    std::size_t end;
    while ((end = buffered_.find('\0')) == std::string::npos) {
        pollfd waiting{fromBrowser_, POLLIN, 0};
        if (::poll(&waiting, 1, kLimitMilliseconds) != 1) throw std::runtime_error("Chromium does not answer");
        std::array<char, 65536> bytes;
        const ssize_t count = ::read(fromBrowser_, bytes.data(), bytes.size());
        if (count <= 0) throw std::runtime_error("Chromium has ended");
        buffered_.append(bytes.data(), static_cast<std::size_t>(count));
    }
    const Json message = Json::parse(buffered_.substr(0, end));
    buffered_.erase(0, end + 1);
    if (message.contains("method")) note(message);
    return message;
}

void Browser::note(const Json& event) {
    const std::string method = event["method"];
    const Json& details = event["params"];
    if (method == "Page.loadEventFired") loaded_ = true;
    if (method == "Network.requestWillBeSent") requests_.push_back(details["request"]["url"]);
    if (method == "Runtime.exceptionThrown") complaints_.push_back(details["exceptionDetails"].dump());
    if (method == "Runtime.consoleAPICalled") complaints_.push_back(details["args"].dump());
    if (method == "Log.entryAdded") complaints_.push_back(details["entry"].dump());
}

Browser::Json Browser::send(const std::string& method, const Json& parameters, const std::string& session) {
    Json command = {{"id", ++lastId_}, {"method", method}, {"params", parameters}};
    if (!session.empty()) command["sessionId"] = session;
    const std::string text = command.dump() + '\0';
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t count = ::write(toBrowser_, text.data() + done, text.size() - done);
        if (count <= 0) throw std::runtime_error("Chromium does not listen");
        done += static_cast<std::size_t>(count);
    }
    for (;;) {
        const Json message = receive();
        if (message.value("id", 0) != lastId_) continue;
        if (message.contains("error")) throw std::runtime_error(method + ": " + message["error"].dump());
        return message["result"];
    }
}

Browser::Json Browser::call(const std::string& method, const Json& parameters) {
    return send(method, parameters, session_);
}

void Browser::open(const std::string& url) {
    loaded_ = false;
    call("Page.navigate", {{"url", url}});
    while (!loaded_) receive();
}

Browser::Json Browser::evaluate(const std::string& expression) {
    const Json answer = call("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}});
    if (answer.contains("exceptionDetails")) throw std::runtime_error(answer["exceptionDetails"].dump());
    return answer["result"].value("value", Json());
}

void Browser::movePointer(double x, double y) {
    call("Input.dispatchMouseEvent", {{"type", "mouseMoved"}, {"x", x}, {"y", y}});
}

void Browser::click(double x, double y) {
    for (const char* type : {"mousePressed", "mouseReleased"}) {
        call("Input.dispatchMouseEvent", {{"type", type}, {"x", x}, {"y", y}, {"button", "left"}, {"clickCount", 1}});
    }
}

void Browser::press(const std::string& key) {
    Json event = {{"key", key}};
    if (key == "Enter") event.update({{"text", "\r"}, {"windowsVirtualKeyCode", 13}});
    if (key == "Tab") event["windowsVirtualKeyCode"] = 9;
    for (const char* type : {"keyDown", "keyUp"}) {
        event["type"] = type;
        call("Input.dispatchKeyEvent", event);
    }
}

void expectQuietAndOffline(const Browser& browser) {
    EXPECT_TRUE(browser.complaints().empty()) << browser.complaints().front();
    for (const std::string& url : browser.requests()) {
        EXPECT_TRUE(url.starts_with("file://") || url.starts_with("data:")) << url;
    }
}

}  // namespace umbrage::cli
