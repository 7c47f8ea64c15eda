// The tree over a scene's bounded shapes, built anew for every frame.
//
// Boxes with up to eight children a node, side by side for eight-wide tests. A node whose children are all
// balls holds the balls themselves in place of their boxes.
#pragma once

namespace odraz {

struct Scene;

struct Node {
    float lo[3][8]; // or the balls' centres
    union {
        float hi[3][8];
        float radius[8];
    };
    int child[8]; // a node, or ~shape
    int count;    // boxes behind it are empty
    bool balls;
};
inline constexpr int kTreeDepth = 20; // most nodes above one another

// Makes scene.nodes of the `bounded` shapes that scene.order lists, by their scene.box; orders them anew.
void buildTree(Scene &scene, int bounded);

} // namespace odraz
