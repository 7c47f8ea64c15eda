// The film's materials: stone greys and warm wood, one accent (copper), one cold (sky).
#pragma once

#include "trace/scene/scene.h"

namespace odraz {

Material darkMarble();                    // black stone with pale veins, polished
Material slate();                         // dark and dull
Material pearl(bool warm, float reflect); // silver, or copper, and so much of a mirror
Material boards();                        // a checker of stone and wood
Material limestone();                     // columns of the hall
Material hallFloor();                     // a checker of two stones, polished
Material plaster(Rgb colour);
Material beamAlong(); // oak that runs along world z, or x
Material beamAcross();
Material granite();
Material oak();
Material glass();
Material mirror();
Material copper();
Material lamp(Rgb radiance); // a body that only glows

} // namespace odraz
