#include "tests/pipeline/config/shot_text.h"

#include <sstream>
#include <type_traits>

#include "sim/bake.h"

namespace carom::pipeline {

namespace {

class Writer {
  public:
    Writer() { out_.precision(17); }

    template <class... Values>
    void line(const Values&... values) {
        ((put(values), out_ << ' '), ...);
        out_ << '\n';
    }
    [[nodiscard]] std::string text() const { return out_.str(); }

  private:
    template <class T>
    void put(const T& value) {
        if constexpr (std::is_enum_v<T>) {
            out_ << static_cast<int>(value);
        } else {
            out_ << value;
        }
    }
    void put(const Easing& value) {
        out_ << static_cast<int>(value.kind) << ' ' << value.x1 << ' ' << value.y1 << ' '
             << value.x2 << ' ' << value.y2;
    }
    void put(const Rational& value) { out_ << value.to_string(); }
    void put(const Focus& value) {
        put(value.distance);
        out_ << ' ' << value.object;
    }
    void put(const AnnotationTime& value) { out_ << value.seconds << ' ' << value.is_moment; }
    void put(const Aperture& value) { out_ << value.value << ' ' << value.is_f_number; }
    void put(const render::Placement& value) {
        out_ << static_cast<int>(value.mapping) << ' ' << value.facing << ' ' << value.rotation;
    }
    template <class T>
    void put(const std::optional<T>& value) {
        value ? put(*value) : put("none");
    }

    std::ostringstream out_;
};

void write_shape(Writer& out, const render::Shape& shape) {
    if (const auto* sphere = std::get_if<render::SphereShape>(&shape)) {
        out.line("sphere", sphere->radius);
    } else if (const auto* box = std::get_if<render::BoxShape>(&shape)) {
        out.line("box", box->size);
    } else if (const auto* rectangle = std::get_if<render::RectangleShape>(&shape)) {
        out.line("rectangle", rectangle->size);
    } else if (const auto* mesh = std::get_if<render::MeshShape>(&shape)) {
        out.line("mesh", mesh->file, mesh->vertices.size(), mesh->triangles.size());
        for (const Vec3& vertex : mesh->vertices) {
            out.line(vertex);
        }
    } else if (const auto* triangle = std::get_if<render::TriangleShape>(&shape)) {
        out.line("triangle", triangle->corners[0], triangle->corners[1], triangle->corners[2]);
    } else if (const auto* sides = std::get_if<render::ParallelogramShape>(&shape)) {
        out.line("parallelogram", sides->corner, sides->edge_u, sides->edge_v);
    } else if (const auto* disk = std::get_if<render::DiskShape>(&shape)) {
        out.line("disk", disk->radius);
    } else if (const auto* cylinder = std::get_if<render::CylinderShape>(&shape)) {
        out.line("cylinder", cylinder->radius, cylinder->height);
    } else if (const auto* cone = std::get_if<render::ConeShape>(&shape)) {
        out.line("cone", cone->radius, cone->top_radius, cone->height);
    }
}

struct ColourWriter {
    Writer& out;
    void operator()(const Vec3& colour) const { out.line(colour); }
    void operator()(const render::ImageTexture& t) const {
        out.line(t.file, t.scale, t.is_linear, t.size, t.offset, t.placement, t.background, t.tint,
                 t.channel);
    }
    void operator()(const render::BallTexture& t) const {
        out.line(t.colour, t.white, t.striped, t.number, t.disc_radius, t.band_width, t.spots);
    }
    void operator()(const render::ClothTexture& t) const {
        out.line(t.colour, t.thread, t.variation, t.wear, t.seed, t.bed, t.nap, t.placement);
    }
    void operator()(const render::WoodTexture& t) const {
        out.line(t.light, t.dark, t.ring, t.grain, t.placement);
    }
    void operator()(const render::CheckerTexture& t) const {
        out.line(t.even, t.odd, t.size, t.placement);
    }
    void operator()(const render::SmudgesTexture& t) const { out.line(t.amount, t.seed); }
    void operator()(const std::shared_ptr<const render::MixTexture>& t) const {
        out.line("mix");
        std::visit(*this, t->a);
        std::visit(*this, t->b);
        (*this)(t->by);
    }
    void operator()(const render::NumberTexture& t) const {
        out.line("range", t.range);
        std::visit(*this, t.pattern);
    }
    void operator()(const render::NumberSource& number) const {
        if (const render::NumberTexture* texture = number.texture()) {
            (*this)(*texture);
        } else {
            out.line(number.constant_or(0));
        }
    }
    void operator()(const std::monostate& /*no relief*/) const {}
    void operator()(const render::NormalPicture& t) const {
        out.line("normal", t.strength);
        (*this)(t.image);
    }
    void operator()(const render::HeightTexture& t) const {
        out.line("height", t.depth);
        (*this)(t.number);
    }
};

void write_surface(Writer& out, const render::StandardMaterial& s) {
    const ColourWriter write{out};
    out.line(s.transmission, s.ior, s.transmission_colour, s.transmission_depth, s.sheen_colour,
             s.bump, s.coat.ior, s.emission_strength);
    for (const render::NumberSource* number : {&s.metal, &s.roughness, &s.specular, &s.sheen,
                                               &s.coat.weight, &s.coat.roughness, &s.opacity}) {
        write(*number);
    }
    std::visit(write, s.base);
    std::visit(write, s.emission);
    std::visit(write, s.relief);
}

struct LightWriter {
    Writer& out;
    void operator()(const render::RectangleLight& l) const {
        out.line(l.centre, l.edge_u, l.edge_v, l.normal, l.radiance, l.falloff, l.beam);
    }
    void operator()(const render::SphereLight& l) const {
        out.line(l.centre, l.radius, l.radiance, l.falloff);
    }
    void operator()(const render::DiskLight& l) const {
        out.line(l.centre, l.radius, l.normal, l.radiance, l.falloff, l.beam);
    }
    void operator()(const render::ShadeLight& l) const {
        out.line(l.centre, l.normal, l.shape.radius, l.shape.top_radius, l.shape.height,
                 l.shape.bulge, l.disk_radius, l.depth, l.albedo, l.radiance);
    }
    void operator()(const render::EnvironmentLight& l) const {
        out.line(l.radiance, l.image, l.rotation);
        if (l.sky) {
            out.line("sky", l.sky->sun, l.sky->turbidity, l.sky->ground);
        }
    }
    void operator()(const render::PointLight& l) const {
        out.line(l.position, l.intensity, l.falloff);
    }
    void operator()(const render::SpotLight& l) const {
        out.line(l.position, l.direction, l.intensity, l.inner_angle, l.outer_angle, l.falloff);
    }
    void operator()(const render::DirectionalLight& l) const {
        out.line(l.direction, l.irradiance);
    }
};

struct PathWriter {
    Writer& out;
    void operator()(const BezierPath& path) const {
        out.line("bezier", path.even_pace, path.easing);
        for (const ControlPoint& point : path.points) {
            (*this)(point);
        }
    }
    void operator()(const SplinePath& path) const {
        out.line("spline", path.even_pace, path.easing);
        for (const ControlPoint& point : path.points) {
            (*this)(point);
        }
    }
    void operator()(const AlongPath& path) const {
        out.line("along", path.object, path.from, path.to, path.offset, path.even_pace,
                 path.easing);
    }
    void operator()(const FollowPath& path) const {
        out.line("follow", path.object, path.offset, path.smoothing, path.look_ahead);
    }
    void operator()(const OrbitPath& path) const {
        out.line("orbit", path.radii.x, path.radii.y, path.start_angle, path.end_angle, path.turn.r,
                 path.turn.v, path.even_pace, path.easing);
        std::visit(*this, path.around);
    }
    void operator()(const ControlPoint& point) const { out.line(point.offset, point.of, point.at); }
};

void write_scene(Writer& out, const render::SceneDescription& scene) {
    for (const render::ObjectDescription& object : scene.objects) {
        out.line("object", object.name, object.track, object.material, object.world_from_object);
        write_shape(out, object.shape);
    }
    for (const render::MaterialDescription& material : scene.materials) {
        out.line("material", material.name);
        write_surface(out, material.surface);
        if (material.phong) {
            const render::PhongMaterial& p = *material.phong;
            out.line("phong", p.ambient.value_or(Vec3(-1, -1, -1)), p.specular, p.shininess,
                     p.reflectance, p.reflectance_spread, p.transmittance, p.transmittance_spread,
                     p.index);
            std::visit(ColourWriter{out}, p.diffuse);
        }
    }
    for (const render::LightDescription& light : scene.lights) {
        out.line("light", light.name);
        std::visit(LightWriter{out}, light.light);
    }
}

template <class T>
void write_changing(Writer& out, const Eased<T>& value) {
    out.line(value.start, value.end, value.easing);
    for (const ValueKey<T>& key : value.keys) {
        out.line(key.video_time, key.value);
    }
}

void write_camera_sound(Writer& out, const CameraSound& sound) {
    out.line("camera sound", sound.gain, sound.pitch, sound.lowest, sound.mirrors_reverse,
             sound.has_delay, sound.stereo, sound.width, sound.ratio);
    if (sound.listener) {
        out.line("listener", sound.listener->is_camera, sound.listener->at, sound.listener->facing);
    }
    for (const std::optional<double>& level : sound.mix) {
        out.line(level);
    }
}

/// The same with the values that hold for what is not given.
CameraSound with_defaults(CameraSound sound) {
    const sound::ClipSettings usual;
    sound.pitch = sound.pitch.value_or(usual.pitch);
    sound.lowest = sound.lowest.value_or(usual.lowest);
    sound.mirrors_reverse = sound.mirrors_reverse.value_or(usual.mirrors_reverse);
    sound.has_delay = sound.has_delay.value_or(usual.has_delay);
    sound.stereo = sound.stereo.value_or(usual.stereo);
    sound.width = sound.width.value_or(usual.width);
    sound.ratio = sound.ratio.value_or(usual.ratio);
    sound.listener = sound.listener.value_or(ListenerPlace{});
    for (std::size_t i = 0; i < sound.mix.size(); ++i) {
        sound.mix[i] = sound.mix[i].value_or(usual.mix[i]);
    }
    return sound;
}

void write_sound(Writer& out, const SoundSettings& sound) {
    const sound::RoomSettings& room = sound.room;
    out.line("sound", sound.is_silent, room.kind, room.size, room.floor_centre,
             room.reverberation_low, room.reverberation_high, sound.bed_reflection,
             sound.full_scale, sound.loudness);
    write_camera_sound(out, with_defaults(sound.cameras));
    for (const SoundMaterial& material : sound.materials) {
        out.line("sound material", material.name, material.modulus, material.poisson, material.loss,
                 material.contact);
        for (const sound::Mode& mode : material.modes.value_or(std::vector<sound::Mode>())) {
            out.line("mode", mode.frequency, mode.q, mode.gain);
        }
    }
}

void write_camera(Writer& out, const CameraRig& rig) {
    out.line("camera", rig.name, rig.video_start, rig.video_end, rig.fade, rig.time_map.scene_start,
             rig.time_map.scene_end, rig.time_map.is_smooth);
    for (const SpeedKey& key : rig.time_map.speeds) {
        out.line(key.video_time, key.speed);
    }
    std::visit(PathWriter{out}, rig.position);
    std::visit(PathWriter{out}, rig.target);
    write_changing(out, rig.fov);
    if (rig.focal_length) {
        write_changing(out, *rig.focal_length);
    }
    out.line(rig.sensor_height, rig.fov_axis, rig.aspect);
    write_changing(out, rig.focus);
    write_changing(out, rig.aperture);
    write_changing(out, rig.roll);
    write_changing(out, rig.up);
    write_changing(out, rig.blades);
    out.line(rig.blade_rotation);
    if (rig.framing) {
        out.line("framing", rig.framing->margin);
        for (const Vec3& point : rig.framing->points) {
            out.line(point);
        }
    }
    if (rig.shake) {
        out.line("shake", rig.shake->strength, rig.shake->frequency, rig.shake->seed);
    }
    write_camera_sound(out, rig.sound);
}

struct AnnotationWriter {
    Writer& out;

    void operator()(const PathAnnotation& path) {
        out.line("path", path.of, path.part, path.length, path.fading, path.marks, path.number,
                 path.on_cloth);
    }
    void operator()(const AimAnnotation& aim) {
        const ScenePoint toward = aim.toward.value_or(ScenePoint{"none"});
        out.line("aim", aim.of, toward.object, toward.at, aim.direction, aim.length);
    }
    void operator()(const GhostAnnotation& ghost) { out.line("ghost", ghost.of, ghost.on); }
    void operator()(const TangentAnnotation& tangent) {
        out.line("tangent", tangent.of, tangent.on, tangent.length);
    }
    void operator()(const VelocityAnnotation& velocity) {
        out.line("velocity", velocity.of, velocity.during, velocity.value);
    }
    void operator()(const SpinAnnotation& spin) {
        out.line("spin", spin.of, spin.during, spin.value);
    }
    void operator()(const AngleAnnotation& angle) {
        for (const ScenePoint& point : angle.points) {
            out.line(point.object, point.at);
        }
        for (const auto* names : {&angle.between, &angle.deflection}) {
            for (const std::string& name : *names) {
                out.line(name);
            }
        }
        out.line("angle", angle.after.seconds, angle.after.is_rolling, angle.radius, angle.value);
    }
    void operator()(const ZoneAnnotation& zone) {
        for (const Vec2& corner : zone.polygon) {
            out.line(corner);
        }
        out.line("zone", zone.radius, zone.at.object, zone.at.at);
    }
    void operator()(const LabelAnnotation& label) { out.line("label", label.of, label.text); }
    void operator()(const TextAnnotation& text) { out.line("text", text.text); }
    void operator()(const TitleAnnotation& title) { out.line("title", title.text, title.subtitle); }
    void operator()(const TipAnnotation& tip) { out.line("tip", tip.of); }
    void operator()(const PlanAnnotation& plan) { out.line("plan", plan.has_paths); }
    void operator()(const ImageAnnotation& image) { out.line("image", image.file); }
};

void write_annotation(Writer& out, const Annotation& annotation) {
    std::visit(AnnotationWriter{out}, annotation.kind);
    const TextBox box = annotation.box.value_or(TextBox{Vec3(0), -1});
    const PicturePlace place = annotation.place.value_or(PicturePlace{{-1, -1}, false});
    out.line(annotation.from, annotation.to, annotation.fade, annotation.opacity, annotation.colour,
             annotation.width, annotation.dash, annotation.font, annotation.size, box.colour,
             box.opacity, place.at, place.is_edge, annotation.lit);
}

}  // namespace

std::string shot_text(const Shot& shot) {
    Writer out;
    out.line("physics", sim::physics_hash(shot.world).to_string());
    write_scene(out, shot.scene);
    for (const CameraRig& rig : shot.cameras) {
        write_camera(out, rig);
    }
    const Shutter& shutter = shot.timing.shutter;
    out.line("timing", shot.timing.fps, shutter.exposure, shutter.clock, shutter.position,
             shutter.switch_ratio);
    const render::RenderSettings& r = shot.render;
    out.line("render", r.width, r.height, r.integrator, r.samples, r.max_bounces, r.clamp, r.filter,
             r.filter_width, r.acceleration, r.seed);
    const render::DistributedSettings& d = r.distributed;
    out.line("distributed", d.pixel_samples, d.blur_samples, d.lens_samples, d.shadow_samples,
             d.reflection_samples, d.refraction_samples, d.recursion_limit, d.falloff,
             d.ambient_coefficient);
    for (const std::string& aov : r.aovs) {
        out.line(aov);
    }
    const OutputSettings& o = shot.output;
    out.line("output", o.preset, o.threads, o.view, o.exposure);
    const Hdr10Settings hdr10 = o.hdr10.value_or(Hdr10Settings{0, 0});
    const MusicSettings music = o.music.value_or(MusicSettings{"", 0, -1});
    out.line("output", static_cast<int>(o.codec.value_or(Codec{-1})), o.crf.value_or(-1),
             o.bit_rate.value_or(-1), o.bits.value_or(-1), hdr10.peak, hdr10.white,
             o.poster.value_or(-1), o.title, static_cast<int>(o.audio.value_or(AudioCodec{-1})),
             o.audio_bit_rate.value_or(-1), music.file, music.gain, music.fade);
    write_sound(out, shot.sound);
    for (const Annotation& annotation : shot.annotations) {
        write_annotation(out, annotation);
    }
    return out.text();
}

}  // namespace carom::pipeline
