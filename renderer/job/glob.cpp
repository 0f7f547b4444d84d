// SPDX-License-Identifier: Apache-2.0
#include "job/glob.h"

#include <vector>

namespace umbrage {

// reached[i]: the glob so far matches the first i characters. Quadratic, never exponential.
bool matchesGlob(std::string_view glob, std::string_view path) {
    std::vector<char> reached(path.size() + 1, 0);
    reached[0] = 1;
    for (std::size_t g = 0; g < glob.size(); ++g) {
        const bool star = glob[g] == '*';
        const bool crossing = star && g + 1 < glob.size() && glob[g + 1] == '*';
        if (crossing) ++g;
        if (star) {
            for (std::size_t i = 0; i < path.size(); ++i)
                if (reached[i] && (crossing || path[i] != '/')) reached[i + 1] = 1;
            continue;
        }
        for (std::size_t i = path.size(); i > 0; --i)
            reached[i] = reached[i - 1] && (path[i - 1] == glob[g] || (glob[g] == '?' && path[i - 1] != '/'));
        reached[0] = 0;
    }
    return reached[path.size()] != 0;
}

}  // namespace umbrage
