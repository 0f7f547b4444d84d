// SPDX-License-Identifier: Apache-2.0
#include "gpu/profiler.h"

#include <utility>

namespace umbrage::gpu {
namespace {

GLuint timestamp() {
    GLuint query = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &query);
    glQueryCounter(query, GL_TIMESTAMP);
    return query;
}

}  // namespace

Profiler::~Profiler() {
    for (const Pending& pending : pending_) {
        for (const GLuint query : {pending.begin, pending.end}) glDeleteQueries(1, &query);
    }
}

void Profiler::pass(int id) {
    if (!enabled_) return;
    if (wallClock_) {
        glFinish();
        const auto now = std::chrono::steady_clock::now();
        if (running_.id != kNoPass) {
            milliseconds_[running_.id] += std::chrono::duration<double, std::milli>(now - running_.start).count();
        }
        running_ = {id, now};
        return;
    }
    if (running_.id != kNoPass) pending_.back().end = timestamp();
    running_.id = id;
    if (id != kNoPass) pending_.push_back({id, timestamp(), 0});
}

std::map<int, double> Profiler::collect() {
    pass(kNoPass);
    for (const Pending& pending : pending_) {
        GLuint64 begin = 0, end = 0;
        glGetQueryObjectui64v(pending.begin, GL_QUERY_RESULT, &begin);
        glGetQueryObjectui64v(pending.end, GL_QUERY_RESULT, &end);
        milliseconds_[pending.id] += double(end - begin) * 1e-6;
        for (const GLuint query : {pending.begin, pending.end}) glDeleteQueries(1, &query);
    }
    pending_.clear();
    return std::exchange(milliseconds_, {});
}

}  // namespace umbrage::gpu
