// The table of keys, with one function per section of the format. Each spec is built on first use
// and is constant afterwards.
#pragma once

#include <span>
#include <string_view>

#include "pipeline/config/film_section.h"
#include "pipeline/config/map_spec.h"
#include "pipeline/config/shot_file.h"

namespace carom::pipeline::config {

/// For a section that is read only to find its problems.
struct NotStored {};

[[nodiscard]] const MapSpec<ShotFile>& shot_spec();

[[nodiscard]] const MapSpec<sim::WorldDescription>& simulation_spec();
[[nodiscard]] const MapSpec<sim::WorldDescription>& physics_spec();
/// `physics.stick`; `mass` is the strike's `stick_mass`.
[[nodiscard]] const MapSpec<sim::Strike>& stick_spec();
/// The keys are checked and not stored, because conditions.h has merged them into `physics`.
[[nodiscard]] const MapSpec<NotStored>& conditions_spec();
[[nodiscard]] const MapSpec<BallSetSection>& ball_set_spec();
[[nodiscard]] const MapSpec<TableSection>& table_spec();
/// Without the file of the set, which is merged before (gather.h).
[[nodiscard]] ValueType<SetSection> set_of_shot();
[[nodiscard]] const MapSpec<RackSection>& rack_spec();
[[nodiscard]] const MapSpec<BallSection>& ball_spec();
[[nodiscard]] const MapSpec<ObjectSection>& object_spec();
[[nodiscard]] const MapSpec<KeyedMotion>& motion_spec();
[[nodiscard]] const MapSpec<EventSection>& event_spec();
/// The keys of a strike that say what it shall do, from which its direction is found.
[[nodiscard]] std::span<const std::string_view> aim_keys();
[[nodiscard]] const MapSpec<render::MaterialDescription>& material_spec();
[[nodiscard]] const MapSpec<CameraRig>& camera_spec();
[[nodiscard]] const MapSpec<RenderSection>& render_spec();
[[nodiscard]] const MapSpec<OutputSettings>& output_spec();
[[nodiscard]] const MapSpec<FilmSection>& film_spec();
[[nodiscard]] const MapSpec<Annotation>& annotation_spec();

/// A text with values in braces, whose braces are checked (value_text.h), but not the objects that
/// it names.
[[nodiscard]] ValueType<std::string> text_with_values(std::string noun);

/// `none`, for a silent film, or the keys of the section `sound`.
[[nodiscard]] ValueType<SoundSettings> film_sound();

/// Frames per second. A decimal number such as 29.97 is read as the fraction that it abbreviates,
/// 30000/1001, with a warning.
[[nodiscard]] ValueType<Rational> frame_rate();

/// Whether the cue stick of a strike is seen.
[[nodiscard]] ValueType<bool> shown_or_hidden();

/// The cue stick of all strikes: a word, or its measures.
[[nodiscard]] ValueType<StickSection> cue_stick();

/// {at, when, after}: the keys for the time of an event, which all kinds have.
void add_event_start(MapSpec<sim::ForceEvent>& spec);
[[nodiscard]] const MapSpec<sim::ForceEvent>& place_spec();
[[nodiscard]] const MapSpec<sim::ForceEvent>& remove_spec();

/// A place on the table: the name of a spot, or two or three coordinates.
[[nodiscard]] ValueType<TablePlace> table_place();

/// A rotation: angles about the world's x, y and z axis, in this order, or {axis, angle}.
[[nodiscard]] ValueType<Quat> rotation();

/// {axis, angle} of up to 100 revolutions, as the unit axis times the angle.
[[nodiscard]] ValueType<Vec3> rotation_vector();

[[nodiscard]] ValueType<std::vector<Named<Lamp>>> lights();
/// The keys of a material's {ball: ...}.
[[nodiscard]] const MapSpec<render::BallTexture>& ball_texture_spec();

}  // namespace carom::pipeline::config
