// SPDX-License-Identifier: Apache-2.0
// The scenes: each function fills a document and states the figures it promises. What each is for: scenes/README.md.
#pragma once

#include "document.h"

namespace generator {

void courtyard(Document& document);
void knight(Document& document);
void knights(Document& document);
void tree(Document& document);
void treeDecomposed(Document& document);
void noiseSpheres(Document& document);
void brabecSeidelA(Document& document);
void brabecSeidelB(Document& document);
void teapotLike(Document& document);
void pole(Document& document);
void pipe(Document& document);
void lantern(Document& document);
void nested(Document& document);
void hall(Document& document);

}  // namespace generator
