// SPDX-License-Identifier: Apache-2.0
// The demo scene's parts: a walled court at dusk, 14 m wide, gate to the north (-Z), arcade to the east (+X), seen
// from the south. courtyard.cpp puts them together and lights them.
#pragma once

#include "document.h"

namespace generator {

struct CourtyardMaterials {
    int paving, brick, wood, stone, iron, bronze, water, glass, flame, leaf, bark;
    int redCloth, blueCloth, ochreCloth, tunic, skin, leather;
};

CourtyardMaterials courtyardMaterials(Document& document);

void addWalls(Document& document, const CourtyardMaterials& materials);
void addArcade(Document& document, const CourtyardMaterials& materials);
void addFountain(Document& document, const CourtyardMaterials& materials);
void addCloths(Document& document, const CourtyardMaterials& materials);
void addFurniture(Document& document, const CourtyardMaterials& materials);
void addPlantedTree(Document& document, const CourtyardMaterials& materials);

/// A cage lantern that hangs from its node's origin; its light stands 0.3 m below. @return the lantern's node
int addHangingLamp(Document& document, const CourtyardMaterials& materials, const LightSpec& light, int parent,
                   const dvec3& hook, const dquat& rotation);

/// The skinned walker, who circles with a lantern. Its light is called HandLamp.
void addWalker(Document& document, const CourtyardMaterials& materials, const dvec3& centre);

/// A mesh of textured (box-mapped) or plain closed shape with its node.
int addPiece(Document& document, const char* name, const Shape& shape, int material, bool textured,
             const dvec3& translation = dvec3(0), Kind kind = Kind::Closed);

}  // namespace generator
