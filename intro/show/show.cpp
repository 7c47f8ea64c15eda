#include "show/show.h"

namespace odraz {

Posed poseAt(const Film &film, double seconds, const CameraKey *camera) {
    Moment m = momentAt(kFilm, seconds * kRowsPerSecond);
    // A hall without light cannot be posed: pose the film's first shot instead, faded to black
    if (kScenes[m.shot->scene].needsHall && !film.hall->solved()) m.shot = kFilm.shots, m.fade = 0;
    Posed now = {m.shot,
                 {m.storyRow, camera ? *camera : pose(m.shot->path, m.storyRow), film.hall, film.facts},
                 m.fade};
    film.scene->clear();
    now.scene().pose(now.input, *film.scene);
    film.scene->finish();
    return now;
}

} // namespace odraz
