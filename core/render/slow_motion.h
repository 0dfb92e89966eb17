#pragma once
#include "frame/prepared.h"
#include "frame/slow_motion.h"
#include "frame/view.h"
#include "options/settings.h"
#include "render/channel_picture.h"
#include "scene/scene.h"

namespace ps {

/// Why the renderer that the settings name cannot show the picture after n of these units; nullopt if it can.
std::optional<std::string_view> slow_motion_lacks(SlowUnit unit, const Settings& settings, const SceneTraits& traits);

/// The first unit that it does not lack, or nullopt: it shows whole pictures alone.
std::optional<SlowUnit> first_slow_unit(const Settings& settings, const SceneTraits& traits);

/// What is shown of what was asked for: nothing, which is the whole picture, for a unit that the renderer lacks and for
/// a channel that compares two whole pictures.
std::optional<SlowMotion> given_slow_motion(const std::optional<SlowMotion>& asked, const Settings& settings,
                                            const SceneTraits& traits, ShownChannel shown);

/// The picture after `motion.at` units, as the renderer's clear path on one thread has it then, in any other order of
/// its threads. Of `request`, channels, region and priority count. Throws InputError for a unit that the renderer lacks
/// and for channels that compare two whole pictures, and as render() does.
SlowFrame render_slowly(const Scene& scene, const View& view, const Settings& settings, const SlowMotion& motion,
                        const RenderRequest& request, Prepared& prepared, Progress& progress);

/// How far it has come, in words: "triangle 17 of 1,284: triangle 5 of teapot".
std::string slow_motion_words(const SlowState& state, const Scene& scene, Vec2i size);

}  // namespace ps
