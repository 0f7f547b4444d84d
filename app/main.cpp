// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>
#include <new>
#include <system_error>

#include "commands.h"
#include "exit_codes.h"

namespace umbrage {
namespace {

int run(int argc, char** argv) {
    int exitCode = kOk;
    const std::optional<Options> options = parseOptions(argc, argv, exitCode);
    if (!options) return exitCode;
    if (options->render) return runRender(*options->render, options->quiet);
    if (options->compare) return runCompare(*options->compare, options->quiet);
    if (options->accept) return runAccept(*options->accept, options->quiet);
    if (options->verify) return runVerify(*options->verify, options->quiet);
    if (options->bench) return runBench(*options->bench, options->quiet);
    if (options->inspect) return runInspect(*options->inspect);
    if (options->stats) return runStats(*options->stats);
    if (options->schema) return runSchema(*options->schema);
    return runDevices();
}

}  // namespace
}  // namespace umbrage

int main(int argc, char** argv) {
    using namespace umbrage;
    try {
        const int exitCode = run(argc, argv);
        if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
            throw Error(ErrorKind::Output, "stdout", "cannot be written");
        }
        return exitCode;
    } catch (const Error& error) {
        std::fprintf(stderr, "umbrage: error: %s\n", error.what());
        return exitCodeOf(error.kind());
    } catch (const std::system_error& error) {  // what fmt throws where stdout is full
        std::fprintf(stderr, "umbrage: error: cannot write: %s\n", error.what());
        return kOutputFailed;
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "umbrage: error: out of memory\n");
        return kBadInput;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "umbrage: a bug in umbrage, please report it: %s\n", error.what());
        return kFramesFailed;
    }
}
