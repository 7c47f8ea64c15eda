// The tree over a scene's bounded shapes, a bounding volume hierarchy. It is rebuilt for every frame.
//
// A node holds the boxes of up to eight children, as a structure of arrays for eight-wide tests. If all its
// children are balls, it holds the balls themselves instead of their boxes.
#pragma once

namespace odraz {

struct Scene;

struct Node {
    float lo[3][8]; // or the balls' centres
    union {
        float hi[3][8];
        float radius[8];
    };
    int child[8]; // index of a node, or ~index of a shape
    int count;    // number of children; boxes from this index on are empty
    bool balls;
};
inline constexpr int kTreeDepth = 20; // greatest number of nodes from the root to a leaf

// Builds scene.nodes from scene.box, over the first `bounded` shapes in scene.order, which it reorders.
void buildTree(Scene &scene, int bounded);

} // namespace odraz
