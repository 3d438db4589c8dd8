#include "pipeline/config/reference_examples.h"

namespace carom::pipeline::config {

// NOLINTNEXTLINE(readability-function-size): a table
const std::map<std::string, std::string>& reference_examples() {
    static const std::map<std::string, std::string> examples{
        {"shot", R"(include: [tables/pool_9ft.yaml, balls/pool.yaml, looks/club.yaml]
simulation: {duration: 3 s}
balls:
  cue: {at: [-0.3, -0.2]}
  eight: {at: [0.8, 0.25]}
events:
  - strike: {ball: cue, at: 0.5 s, toward: eight, speed: 3 m/s}
cameras:
  - video: [0 s, 3 s]
    scene: [0 s, 3 s]
    position: [-1.1, -0.45, 0.36]
    target: [0.7, 0.15, 0]
)"},
        {"simulation", R"(simulation: {duration: 6 s, seed: 7}
)"},
        {"key_reduction", R"(simulation:
  key_reduction: {position_error: 0.01 mm, orientation_error: 0.05 deg}
)"},
        {"physics", R"(physics:
  gravity: 9.81 m/s^2
  ball_ball: {restitution: 0.93}
  pairs:
    - {between: [ball, floor], friction: 0.35, restitution: 0.1}
)"},
        {"set", R"(table: {kind: pool}
set: {file: club, near: 2 m}
)"},
        {"stick", R"(physics:
  shaft: low_deflection
  stick: {mass: 19 oz}
)"},
        {"conditions", R"(physics: {cloth: club, balls: dirty}
conditions:
  cloth:
    club:
      ball_cloth: {sliding_friction: 0.24, rolling_friction: 0.012}
)"},
        {"condition", R"(physics: {tip: soft, shaft: club}
conditions:
  tip: {soft: {stick: {mass: 18 oz}}}
  shaft: {club: {stick: {end_mass_ratio: 1/25}}}
)"},
        {"ball_cloth", R"(physics:
  ball_cloth: {sliding_friction: 0.15, rolling_friction: 0.008}
)"},
        {"ball_ball", R"(physics:
  ball_ball: {restitution: 0.95, friction: alciatore}
)"},
        {"ball_cushion", R"(physics:
  ball_cushion: {model: han2005, restitution: 0.8}
)"},
        {"cushion_restitution", R"(physics:
  ball_cushion:
    restitution: {slow: 0.9, falls_above: 1.9 m/s, by: 0.09, least: 0.7}
)"},
        {"mirror", R"(physics:
  ball_cushion: {model: mirror, mirror: {restitution: 1}}
)"},
        {"han2005", R"(physics:
  ball_cushion:
    model: han2005
    han2005: {restitution: 0.8, friction: 0.2}
)"},
        {"mathavan2010", R"(physics:
  ball_cushion:
    model: mathavan2010
    mathavan2010: {restitution: 0.98, friction: 0.14}
)"},
        {"otherwise", R"(physics:
  otherwise: {restitution: 0.2, friction: 0.5}
)"},
        {"pair", R"(physics:
  pairs:
    - {between: [ball, rail], friction: 0.15, restitution: 0.5}
)"},
        {"ball_set", R"(ball_set: {kind: snooker, mass: 142 g}
)"},
        {"table", R"(table: {kind: pool, size: 8 ft}
)"},
        {"pockets", R"(table:
  pockets:
    corner: {drop: 100 mm}
    side: {drop: 100 mm}
)"},
        {"pocket", R"(table:
  pockets:
    corner: {shelf: 45 mm, hole_radius: 51 mm}
)"},
        {"solve", R"(table: {kind: pool}
balls:
  cue: {at: [-0.4, -0.1]}
  one: {at: [0.8, 0.3]}
events:
  - strike: {ball: cue}
solve:
  want: [{potted: one, in: top right}]
  prefer: [likely, slow]
  player: professional
)"},
        {"want", R"(table: {kind: pool}
balls:
  cue: {at: [-0.4, -0.1]}
  one: {at: [0.8, 0.3]}
events:
  - strike: {ball: cue}
solve:
  want:
    - {potted: one}
    - {cushions: one, at_least: 1, before: {potted: one}}
  avoid: [{contact: [cue, cushion], by: 0.2 s}]
)"},
        {"player", R"(table: {kind: pool}
balls:
  cue: {at: [-0.4, -0.1]}
  one: {at: [0.8, 0.3]}
events:
  - strike: {ball: cue, speed: 2.5 m/s}
solve:
  want: [{potted: one}]
  player: {direction: 0.2 deg, elevation: 0.1 deg, speed: 0.05, tip: 0.02}
)"},
        {"rack", R"(table: {kind: pool}
rack: {set: nine_ball, gap: 0.05 mm}
balls: {cue: {at: [-0.75, 0.12]}}
)"},
        {"ball", R"(table: {kind: pool}
balls:
  cue: {at: [-0.3, -0.2], velocity: [2, 0.5], spin: [0 rad/s, 0 rad/s, 20 rad/s]}
  eight: {at: [0.8, 0.25]}
)"},
        {"touching", R"(table: {kind: pool}
balls:
  cue: {at: [-0.3, 0]}
  one: {touching: {ball: cue, direction: 30 deg}}
)"},
        {"rotation", R"(table: {kind: pool}
balls:
  eight: {at: [0.8, 0.25], rotate: {axis: [0, 0, 1], angle: 30 deg}}
)"},
        {"ball look", R"(balls:
  cue: {at: [-0.3, -0.2], look: {spots: 6}}
  mine: {at: [0.5, 0], look: {colour: [0.4, 0.02, 0.02], striped: true, number: 42}}
)"},
        {"object", R"(objects:
  block:
    box: [40 mm, 120 mm, 40 mm]
    at: [0.2, 0, 0.02]
    rotate: [0, 0, 30 deg]
    physics: {density: 650 kg/m^3}
)"},
        {"repeat", R"(objects:
  tile:
    box: [10 mm, 32 mm, 60 mm]
    at: [0, 0, 0.03]
    physics: {density: 1800 kg/m^3}
    repeat: {count: 12, along: {arc: [0, 0], radius: 30 cm, angles: [0 deg, 90 deg]}}
  tile_12: {rotate: [0, 0, 170 deg]}
)"},
        {"repeat path", R"(objects:
  brick:
    box: [6 cm, 3 cm, 2 cm]
    at: [0, 0, 0.01]
    repeat: {count: [8, 5], along: {from: [-0.3, 0], steps: [[7 cm, 0], [0, 0, 2 cm]]}}
  post:
    cylinder: {radius: 1 cm, height: 10 cm}
    at: [0, 0, 0.05]
    repeat: {count: 6, along: {spline: [[-0.4, 0.3], [0, 0.45], [0.4, 0.3]]}}
)"},
        {"cone", R"(objects:
  marker: {cone: {radius: 45 mm, top_radius: 8 mm, height: 110 mm}, at: [0.5, 0.2, 0.055]}
)"},
        {"capsule", R"(objects:
  pill: {capsule: {radius: 15 mm, length: 40 mm}, at: [0.2, 0, 0.035], physics: {mass: 50 g}}
)"},
        {"cylinder", R"(objects:
  barrel:
    cylinder: {radius: 28 mm, height: 80 mm}
    at: [0.2, 0, 0.04]
    physics: {density: 650 kg/m^3}
)"},
        {"rounded box", R"(objects:
  die:
    rounded_box: {size: [16 mm, 16 mm, 16 mm], radius: 3 mm}
    at: [0.2, 0, 0.008]
    physics: {density: 1200 kg/m^3}
)"},
        {"object physics", R"(objects:
  tile:
    box: [10 mm, 32 mm, 60 mm]
    at: [0.2, 0, 0.03]
    physics: {density: 1800 kg/m^3, material: tile, velocity: [0.1, 0, 0]}
)"},
        {"motion", R"(objects:
  plank:
    box: [36 cm, 9 cm, 2 cm]
    physics: true
    motion:
      easing: linear
      keys:
        - {at: 0.5 s, position: [-0.78, 0, 0.02]}
        - {at: 2.5 s, position: [-0.78, 0, 0.20]}
)"},
        {"motion key", R"(objects:
  plank:
    box: [36 cm, 9 cm, 2 cm]
    motion:
      keys:
        - {at: 0.5 s, position: [-0.78, 0, 0.011]}
        - {at: 2.5 s, position: [-0.79, 0, 0.051], rotate: [0 deg, 13 deg, 0 deg]}
)"},
        {"turn", R"(objects:
  bar:
    box: [56 cm, 24 mm, 40 mm]
    at: [0.05, 0, 0.026]
    motion:
      keys:
        - {at: 2 s}
        - {at: 4 s, turn: {axis: [0, 0, 1], angle: 720 deg}}
)"},
        {"event", R"(table: {kind: pool}
balls: {cue: {at: [-0.3, -0.2]}}
events:
  - strike: {ball: cue, at: 0.5 s, direction: 20 deg, speed: 3 m/s}
  - velocity: {object: cue, at: 2 s, linear: [0, 0, 0]}
)"},
        {"strike", R"(table: {kind: pool}
balls: {cue: {at: [-0.3, -0.2]}, eight: {at: [0.8, 0.25]}}
events:
  - strike: {ball: cue, at: 0.5 s, pot: eight, in: top right, speed: 3 m/s, tip: [0.2, -0.3], elevation: 5 deg}
  - strike: {ball: cue, when: {resting: all}, direction: 75 deg, speed: 2 m/s}
)"},
        {"place", R"(table: {kind: snooker}
balls: {white: {at: [-1.1, 0.1]}, red_1: {at: [0.3, 0.4]}, black: {at: black}}
events:
  - strike: {ball: white, toward: black, speed: 3 m/s}
  - place: {ball: black, spot: black, when: {potted: black}, after: 1 s, if_occupied: next}
)"},
        {"remove", R"(table: {kind: pool}
balls: {cue: {at: head}, eight: {at: foot}}
events:
  - strike: {ball: cue, toward: eight, speed: 2 m/s}
  - remove: {ball: eight, at: 5 s}
)"},
        {"when", R"(table: {kind: pool}
balls: {cue: {at: [-0.3, -0.2]}, eight: {at: [0.8, 0.25]}}
events:
  - strike: {ball: cue, toward: eight, speed: 3 m/s}
  - impulse:
      object: cue
      when: {contact: [eight, cushion]}
      after: 0.2 s
      newton_seconds: [0, 0.2, 0]
)"},
        {"moment", R"(table: {kind: pool}
balls: {cue: {at: [-0.3, -0.2]}, eight: {at: [0.8, 0.25]}}
events:
  - strike: {ball: cue, at: 0.5 s, toward: eight, speed: 3 m/s}
cameras:
  - video: [0 s, 4 s]
    scene: [{strike: cue, before: 0.3 s}, {contact: [cue, eight], after: 0.2 s}]
    position: [-1.1, -0.45, 0.36]
    target: {follow: cue}
)"},
        {"crossing", R"(table: {kind: pool}
balls: {cue: {at: [-0.3, -0.2]}}
events:
  - strike: {ball: cue, direction: 0 deg, speed: 2 m/s}
  - force:
      object: cue
      when: {crossing: {object: cue, from: [0.2, -0.6], to: [0.2, 0.6]}}
      for: 0.5 s
      newtons: [0, 0.3, 0]
)"},
        {"impulse", R"(table: {kind: pool}
balls: {eight: {at: [0.8, 0.25]}}
events:
  - impulse: {object: eight, at: 1 s, newton_seconds: [0, -0.12, 0]}
)"},
        {"force", R"(table: {kind: pool}
balls: {eight: {at: [0.8, 0.25]}}
events:
  - force: {object: eight, at: 1 s, for: 0.5 s, newtons: [0.3, 0, 0]}
)"},
        {"torque", R"(table: {kind: pool}
balls: {eight: {at: [0.8, 0.25]}}
events:
  - torque: {object: eight, at: 1 s, for: 0.2 s, newton_metres: [0, 0, 0.002]}
)"},
        {"velocity", R"(table: {kind: pool}
balls: {cue: {at: [-0.3, -0.2]}}
events:
  - velocity: {object: cue, at: 1 s, linear: [0.8, 0.3, 0], angular: [0, 0, 20 rad/s]}
)"},
        {"cue stick", R"(table: {kind: pool}
balls: {cue: {at: [-0.3, -0.2]}, eight: {at: [0.8, 0.25]}}
events:
  - strike: {ball: cue, at: 3 s, toward: eight, speed: 3 m/s, elevation: 5 deg}
stick: {length: 1.48 m, tip: 12.5 mm}
)"},
        {"material", R"(materials:
  brass: {standard: {base: [0.78, 0.56, 0.26], metal: 1, roughness: 0.22}}
  chalk: {phong: {diffuse: [0.06, 0.17, 0.33]}}
)"},
        {"standard", R"(materials:
  frosted: {standard: {base: [1, 1, 1], transmission: 1, ior: 1.5, roughness: 0.4}}
  lacquer: {standard: {base: [0.42, 0.02, 0.015], roughness: 0.4, coat: {roughness: 0.05}}}
)"},
        {"texture", R"(materials:
  floor: {standard: {base: {checker: {even: 0.6, odd: 0.1, size: 20 cm}}}}
)"},
        {"image", R"(materials:
  rail: {standard: {base: {image: {file: logo.png, size: [20 cm, 10 cm]}}}}
  rock: {standard: {base: {image: {file: logo.png, mapping: box, tint: [1, 0.9, 0.8]}}}}
)"},
        {"texture mix", R"(materials:
  # A label on wood: its transparent parts show the wood.
  crate:
    standard:
      base:
        mix:
          a: {wood: {}}
          b: {image: logo.png}
          by: {image: logo.png}
)"},
        {"number texture", R"(materials:
  worn: {standard: {base: 0.4, metal: 1, roughness: {image: logo.png, range: [0.15, 0.5]}}}
)"},
        {"number image", R"(materials:
  # One file of occlusion, roughness and metal in red, green and blue.
  robot:
    standard:
      base: 0.6
      roughness: {image: {file: logo.png, channel: green}}
      metal: {image: {file: logo.png, channel: blue}}
  leaf: {standard: {base: {image: logo.png}, opacity: {image: logo.png}}}
)"},
        {"normal", R"(materials:
  tiles: {standard: {base: 0.5, normal: {image: logo.png, strength: 0.6}}}
)"},
        {"normal image", R"(materials:
  tiles: {standard: {base: 0.5, normal: {image: {file: logo.png, mapping: box, size: [1 m, 1 m]}}}}
)"},
        {"height", R"(materials:
  grip: {standard: {base: 0.1, height: {checker: {size: 4 mm}, depth: 0.5 mm}}}
)"},
        {"cloth", R"(materials:
  cloth: {standard: {base: {cloth: {colour: [0.02, 0.15, 0.045], variation: 0.2}}, roughness: 0.9}}
)"},
        {"wood", R"(materials:
  rail:
    standard:
      base: {wood: {light: [0.44, 0.27, 0.13], dark: [0.23, 0.12, 0.05], ring: 5 mm}}
)"},
        {"smudges", R"(materials:
  ball:
    standard:
      roughness: 0.1
      specular: {smudges: {amount: 0.4, seed: 2}, range: [0.35, 0.8]}
      coat: {ior: 1.6}
)"},
        {"checker", R"(materials:
  floor:
    standard:
      base: {checker: {even: [0.1, 0.1, 0.11], odd: [0.05, 0.05, 0.06], size: 10 cm}}
)"},
        {"ball paint", R"(materials:
  prize:
    standard:
      base: {ball: {colour: [0.4, 0.02, 0.02], striped: true, number: 42}}
      coat: {roughness: 0}
objects:
  prize: {sphere: 60 mm, at: [0, 0, 0.06], material: prize}
)"},
        {"coat", R"(materials:
  rail: {standard: {base: [0.1, 0.03, 0.01], roughness: 0.5, coat: {weight: 0.8, roughness: 0.15}}}
)"},
        {"phong", R"(materials:
  glass:
    phong: {diffuse: 0.02, specular: 0.8, reflectance: 0.08, transmittance: 0.88, index: 1.5}
)"},
        {"light", R"(lights:
  lamp: {rectangle: [1.7 m, 0.4 m], at: [0, 0, 1.05], facing: [0, 0, -1], radiance: [13, 12, 10]}
  evening: {spot: [26, 24, 20], at: [-0.5, -1, 1.6], facing: [0.5, 1, -1], angle: [16 deg, 24 deg]}
  room: {environment: 0.05}
)"},
        {"shade", R"(lights:
  pendant:
    shade: {radius: 20 cm, top_radius: 4 cm, height: 22 cm, bulge: 0.7, disk: 12 cm, depth: 8 cm}
    at: [0, 0, 1.05]
    lumens: 2600
)"},
        {"tube", R"(lights:
  tube: {tube: {length: 1.2 m, radius: 13 mm}, at: [0, 0, 1.6], lumens: 2500}
)"},
        {"sky", R"(lights:
  sky: {environment: {sun: [-0.75, -0.8, 0.5], turbidity: 2.6, ground: [0.06, 0.1, 0.04]}}
  sun: {directional: [560, 520, 450], facing: [0.75, 0.8, -0.5]}
output: {exposure: -7}
)"},
        {"camera", R"(table: {kind: pool}
balls: {cue: {at: [-0.3, -0.2]}}
cameras:
  - name: seat
    video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: {bezier: [[-1.1, -0.45, 0.36], [-0.9, -0.6, 0.3]]}
    target: [0, 0, 0]
    fov: [40 deg, 30 deg]
    focus: cue
    f_number: 4
)"},
        {"speeds", R"(cameras:
  - video: [0 s, 4 s]
    scene: {from: 0.5 s, speeds: [[0 s, 1], [1 s, 1/16], [3 s, 1/16], [4 s, 1]], easing: smooth}
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
)"},
        {"path", R"(table: {kind: pool}
balls: {cue: {at: [-0.3, -0.2]}}
cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: {orbit: [0, 0, 0.85], radius: [2.6 m, 2.1 m], angles: [-150 deg, 30 deg]}
    target: {follow: cue, smoothing: 0.2 s}
)"},
        {"control point", R"(table: {kind: pool}
balls: {cue: {at: [-0.3, -0.2]}}
cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: {bezier: [[-1.1, -0.45, 0.36], {of: cue, at: 0.5 s, offset: [-0.4, 0, 0.2]}]}
    target: [0, 0, 0]
)"},
        {"changing fov", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    fov: {from: 40 deg, to: 30 deg, easing: smooth}
)"},
        {"lens", R"(cameras:
  - video: [0 s, 1 s]
    scene: [0 s, 1 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    focal_length: 50 mm
    f_number: 2
    lens: {squeeze: 0.55, distortion: -0.02, breathing: 0.5, falloff: 0.6, lateral_colour: 0.001}
  - {video: [1 s, 2 s], scene: 1 s, position: [0, -2, 1], target: [0, 0, 0], lens: prime}
)"},
        {"cat_eye", R"(cameras:
  - video: [0 s, 1 s]
    scene: [0 s, 1 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    f_number: 1.4
    lens: {cat_eye: {ratio: 1.1, shift: 0.6}, falloff: 0.5}
)"},
        {"changing focal_length", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    focal_length: {from: 28 mm, to: 35 mm, easing: smooth}
)"},
        {"changing focus", R"(table: {kind: pool}
balls: {cue: {at: [-0.3, -0.2]}}
cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    focus: {from: cue, to: auto, easing: smooth}
    f_number: 4
)"},
        {"changing aperture", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    aperture: {from: 0 mm, to: 6 mm}
)"},
        {"changing f_number", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    f_number: {from: 8, to: 2.8}
)"},
        {"changing blades", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    f_number: 4
    blades: {from: 5, to: 9}
)"},
        {"changing roll", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    roll: {from: 0 deg, to: 10 deg, easing: [0.3, 0, 0.5, 1]}
)"},
        {"changing up", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [0, 0, 3]
    target: [0, 0, 0]
    up: {from: [0.2, 1, 0], to: [0, 1, 0]}
)"},
        {"fov at times", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    fov: {keys: [[0 s, 40 deg], [0.5 s, 40 deg], [1.5 s, 25 deg]], easing: smooth}
)"},
        {"focal_length at times", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    focal_length: {keys: [[0.5 s, 28 mm], [1.5 s, 50 mm]]}
)"},
        {"focus at times", R"(table: {kind: pool}
balls: {cue: {at: [-0.3, -0.2]}, eight: {at: [0.8, 0.25]}}
cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    focus: {keys: [[0 s, cue], [0.8 s, cue], [1.2 s, eight], [2 s, 1.5 m]], easing: smooth}
    f_number: 4
)"},
        {"aperture at times", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    aperture: {keys: [[0 s, 0 mm], [1 s, 6 mm], [2 s, 2 mm]]}
)"},
        {"f_number at times", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    f_number: {keys: [[0 s, 16], [1 s, 2.8], [2 s, 5.6]]}
)"},
        {"blades at times", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    f_number: 4
    blades: {keys: [[0 s, 5], [1 s, 9]]}
)"},
        {"roll at times", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    roll: {keys: [[0 s, 0 deg], [1 s, 10 deg], [2 s, 0 deg]], easing: smooth}
)"},
        {"up at times", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [0, 0, 3]
    target: [0, 0, 0]
    up: {keys: [[0 s, [0, 1, 0]], [1.5 s, [0.3, 1, 0]]]}
)"},
        {"shake", R"(cameras:
  - video: [0 s, 2 s]
    scene: [0 s, 2 s]
    position: [-1.1, -0.45, 0.36]
    target: [0, 0, 0]
    shake: {kind: handheld, strength: 0.4 deg, frequency: 0.8 Hz, seed: 7}
)"},
        {"film", R"(film:
  size: [1280, 720]
  shots:
    - {title: A lesson, for: 2 s, fade: 0.5 s}
    - lesson.yaml
    - {shot: lesson.yaml, from: 1 s, to: 3 s, fade: 0.5 s}
)"},
        {"part", R"(film:
  shots:
    - {shot: break.yaml, set: {render.samples: 64}, to: 4 s}
    - {title: Again, subtitle: from the other side, for: 1.5 s, fade: 0.25 s}
)"},
        {"render", R"(render: {size: [1280, 720], fps: 30, samples: 32, noise: 0.02, max_bounces: 6}
)"},
        {"shutter", R"(render: {shutter: {time: 1/250 s, clock: scene}}
)"},
        {"distributed", R"(render:
  integrator: distributed
  distributed: {pixel_samples: 4, blur_samples: 8, lens_samples: 8, shadow_samples: 4}
)"},
        {"sound", R"(sound:
  room: hall
  pitch: keep
  dynamics: natural
  loudness: -23 LUFS
  mix: {rolling: 6 dB}
)"},
        {"room", R"(sound:
  room: {size: [12 m, 9 m, 3.5 m], reverberation: [0.9 s, 0.5 s]}
)"},
        {"listener", R"(sound:
  listener: {at: [0, -1.6, 0.5], facing: [0, 1, -0.2]}
)"},
        {"mix", R"(sound:
  mix: {cushions: 3 dB, rolling: -6 dB}
)"},
        {"full scale", R"(sound: {gain: {full_scale: 20 Pa}}
)"},
        {"sound material", R"(balls: {cue: {at: [-0.3, 0]}}
objects:
  block:
    box: [40 mm, 120 mm, 40 mm]
    at: [0.2, 0, 0.02]
    physics: {density: 650 kg/m^3, material: oak}
sound:
  materials:
    ball: {modulus: 9 GPa}
    oak: {modulus: 12 GPa, poisson: 0.35, loss: 0.01}
    tip: {contact: 0.8 ms}
)"},
        {"mode", R"(sound:
  materials:
    cushion:
      contact: 5 ms
      modes:
        - {frequency: 140 Hz, q: 5, gain: 0.3}
        - {frequency: 430 Hz, q: 8, gain: 0.45}
)"},
        {"camera sound", R"(cameras:
  - video: [0 s, 1 s]
    scene: [0 s, 1 s]
    position: [0, -2, 1]
    target: [0, 0, 0]
    sound: {gain: -6 dB, pitch: keep}
  - {video: [1 s, 2 s], scene: 1 s, position: [0, -2, 1], target: [0, 0, 0], sound: none}
)"},
        {"camera mix", R"(cameras:
  - video: [0 s, 1 s]
    scene: [0 s, 1 s]
    position: [0, -2, 1]
    target: [0, 0, 0]
    sound: {mix: {rolling: 6 dB}}
)"},
        {"output", R"(output: {codec: hevc, bits: 10, crf: 20, view: agx, exposure: 0.5}
)"},
        {"ocio", R"(output:
  view: ocio
  ocio: {colour_space: Linear Rec.709 (sRGB), display: sRGB - Display}
)"},
        {"denoise", R"(output: {denoise: {strength: 0.8}}
)"},
        {"grade", R"(output: {grade: {slope: 1.06, offset: [0.004, 0, -0.006], saturation: 1.1}}
)"},
        {"glow", R"(output: {glow: {strength: 0.04, radius: 0.05}}
)"},
        {"hdr10", R"(output: {hdr10: {peak: 1000, white: 203}}
)"},
        {"music", R"(output: {audio: opus, music: {file: piano.flac, gain: -12 dB, fade: 3 s}}
)"},
        {"overlay", R"(output: {overlay: {show: [scene_time, playback_speed], corner: bottom_right}}
)"},
        {"annotation", R"(balls: {cue: {at: [-0.6, 0]}, one: {at: [0.2, 0.05]}}
annotations:
  - {path: {of: cue}, width: 0.01, dash: dashed, from: 0.2 s, fade: 0.1 s}
  - {text: "{cue.speed:.1f} m/s", position: top_right, size: 0.06}
)"},
        {"drawn path", R"(balls: {cue: {at: [-0.6, 0]}, one: {at: [0.2, 0.05]}}
annotations:
  - path: {of: cue, part: whole, marks: 0.1 s, on_cloth: true}
)"},
        {"aim line", R"(balls: {cue: {at: [-0.6, 0]}, one: {at: [0.2, 0.05]}}
annotations:
  - aim: {of: cue, toward: one}
)"},
        {"ghost ball", R"(balls: {cue: {at: [-0.6, 0]}, one: {at: [0.2, 0.05]}}
annotations:
  - ghost: {of: cue, on: one}
)"},
        {"tangent line", R"(balls: {cue: {at: [-0.6, 0]}, one: {at: [0.2, 0.05]}}
annotations:
  - tangent: {of: cue, on: one, length: 60 cm}
)"},
        {"velocity arrow", R"(balls: {cue: {at: [-0.6, 0]}, one: {at: [0.2, 0.05]}}
annotations:
  - velocity: {of: cue, during: 0.1 s, value: true}
)"},
        {"spin arrow", R"(balls: {cue: {at: [-0.6, 0]}, one: {at: [0.2, 0.05]}}
annotations:
  - spin: {of: cue, during: 20 ms}
)"},
        {"drawn angle", R"(balls: {cue: {at: [-0.6, 0]}, one: {at: [0.2, 0.05]}}
annotations:
  - angle: {deflection: [cue, one], after: 0.5 s}
  - angle: {points: [[0, 0], cue, one], radius: 10 cm}
)"},
        {"zone", R"(balls: {cue: {at: [-0.6, 0]}, one: {at: [0.2, 0.05]}}
annotations:
  - zone: {polygon: [[0.3, 0], [0.6, 0], [0.6, 0.2]]}
  - zone: {radius: 15 cm, at: one}
)"},
        {"label", R"(balls: {cue: {at: [-0.6, 0]}, one: {at: [0.2, 0.05]}}
annotations:
  - label: {of: one, text: "{one.speed:.1f} m/s"}
)"},
        {"title", R"(annotations:
  - title: {text: The 30-degree rule, subtitle: a half-ball hit}
    to: 2 s
    fade: 0.5 s
)"},
        {"tip diagram", R"(balls: {cue: {at: [-0.6, 0]}, one: {at: [0.2, 0.05]}}
events: [{strike: {ball: cue, at: 0.2 s, toward: one, speed: 2 m/s, tip: [0.2, 0.3]}}]
annotations:
  - {tip: {of: cue}, position: bottom_right}
)"},
        {"small plan", R"(balls: {cue: {at: [-0.6, 0]}, one: {at: [0.2, 0.05]}}
annotations:
  - {plan: {paths: false}, size: 0.3, position: top_left}
)"},
    };
    return examples;
}

}  // namespace carom::pipeline::config
