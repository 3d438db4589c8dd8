/// The server's shapes as what the view draws.
import { Color } from 'three';
import { kAnnotationsNumbersPerPoint, type AnnotationShape, type Triple } from '../../protocol';
import type { SceneAnnotations } from '../../state/state';
import { kColours } from '../gizmos/figure';
import type { ShownArea } from './areas';
import type { ShownLine } from './line_pieces';
import type { PlacedText } from './texts';

const kDarkEdge: Triple = [13 / 255, 16 / 255, 19 / 255]; // sRGB (pipeline/picture/colours.cpp)

const kHalo = 0.008; // by which a line that stands out is broader, picture heights

export interface ShownShapes {
    areas: ShownArea[];
    lines: ShownLine[];
    texts: PlacedText[];
}

/// From a linear colour to an sRGB one.
function encoded(linear: Triple): Triple {
    const clamped = linear.map((value) => Math.min(Math.max(value, 0), 1)) as Triple;
    return new Color().setRGB(...clamped).convertLinearToSRGB().toArray() as Triple;
}

function css(linear: Triple): string {
    return `rgb(${encoded(linear).map((value) => Math.round(255 * value)).join(' ')})`;
}

function pointsOf(shape: AnnotationShape, numbers: Float64Array) {
    const at = (i: number) => shape.first + i * kAnnotationsNumbersPerPoint;
    const all = Array.from({ length: shape.points }, (_, i) => i);
    return {
        points: all.map((i) => [...numbers.subarray(at(i), at(i) + 3)] as Triple),
        strengths: all.map((i) => shape.opacity * (numbers[at(i) + 3] ?? 1)),
    };
}

/// `chosen`: the index of the annotation that stands out, by broad lines below all others.
export function shownShapes(answer: SceneAnnotations | null, chosen: number): ShownShapes {
    const shown: ShownShapes = { areas: [], lines: [], texts: [] };
    const halos: ShownLine[] = [];
    const bright = new Color(kColours.accent);
    const accent = bright.clone().convertLinearToSRGB().toArray() as Triple;
    for (const shape of answer?.head.shapes ?? []) {
        const { points, strengths } = pointsOf(shape, answer?.numbers ?? new Float64Array());
        const isChosen = shape.annotation === chosen;
        const [first] = points;
        if (shape.kind === 'area') {
            shown.areas.push({
                corners: points, colour: encoded(shape.colour), opacity: shape.opacity,
            });
        } else if (shape.kind === 'line') {
            const line = {
                points, strengths, colour: encoded(shape.colour), edge: kDarkEdge,
                width: shape.width, isClosed: shape.is_closed,
                hasRoundEnds: shape.has_round_ends, hasHead: shape.has_head,
            };
            shown.lines.push(line);
            if (isChosen) {
                halos.push({ ...line, colour: accent, edge: accent, width: line.width + kHalo,
                    hasHead: false });
            }
        } else if (shape.label && first) {
            shown.texts.push({
                at: first, label: shape.label, colour: css(shape.colour), opacity: shape.opacity,
                boxColour: css(shape.label.box_colour), edge: isChosen ? bright.getStyle() : null,
            });
        }
    }
    return { ...shown, lines: [...halos, ...shown.lines] };
}
