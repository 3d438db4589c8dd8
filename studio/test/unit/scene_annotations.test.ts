/// Annotations in the scene: what is asked and when, and the shapes that the view draws of an answer.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { AnnotationShape, Triple } from '../../src/protocol';
import { isInScene } from '../../src/view/annotation_boxes';
import { trianglesOf } from '../../src/view/scene_annotations/areas';
import {
    kCoreOnly, kEdgeOnly, kHead, kJoinsAfter, kJoinsBefore, kNumbersPerPiece, kRound, linePieces,
    withoutHead, type ShownLine,
} from '../../src/view/scene_annotations/line_pieces';
import { NewestQuestion } from '../../src/view/scene_annotations/newest_question';
import { shownShapes } from '../../src/view/scene_annotations/shown_shapes';
import { sizeOfText } from '../../src/view/scene_annotations/text_picture';

interface Asked {
    v: number;
    time: number;
}

function asking(canSend = () => true) {
    const sent: [number, number][] = [];
    const questions = new NewestQuestion<Asked>((number, { time }) => {
        if (canSend()) {
            sent.push([number, time]);
        }
        return canSend();
    });
    return { questions, sent };
}

test('NewestQuestion_OneIsUnderWay_TheNewestFollows', () => {
    const { questions, sent } = asking();
    [1, 2, 3].forEach((time) => questions.ask({ v: 1, time }));
    assert.deepEqual(sent, [[1, 1]]);
    assert.equal(questions.answered(1), true);
    assert.deepEqual(sent, [[1, 1], [2, 3]]);
    questions.ask({ v: 1, time: 3 });
    assert.equal(questions.answered(1), false);
    assert.equal(questions.answered(2), true);
    questions.ask({ v: 1, time: 3 });
    assert.deepEqual(sent, [[1, 1], [2, 3]], 'the same is not asked twice');
    assert.equal(questions.isWaiting, false);
});

test('NewestQuestion_OfAnotherVersion_DoesNotWait', () => {
    const { questions, sent } = asking();
    questions.ask({ v: 1, time: 1 });
    questions.ask({ v: 2, time: 1 });
    assert.deepEqual(sent, [[1, 1], [2, 1]]);
    assert.equal(questions.answered(1), false);
    assert.equal(questions.isWaiting, true);
});

test('NewestQuestion_ReturnedToTheOneUnderWay_IsNotAskedAgain', () => {
    const { questions, sent } = asking();
    questions.ask({ v: 1, time: 1 });
    questions.ask({ v: 1, time: 2 });
    questions.ask({ v: 1, time: 1 });
    questions.answered(1);
    assert.deepEqual(sent, [[1, 1]]);
});

test('NewestQuestion_FailedOrForgotten_MayBeAskedAgain', () => {
    const { questions, sent } = asking();
    questions.ask({ v: 1, time: 1 });
    questions.ask({ v: 1, time: 2 });
    questions.failed();
    assert.deepEqual(sent, [[1, 1], [2, 2]]);
    questions.ask(null);
    questions.ask({ v: 1, time: 2 });
    assert.deepEqual(sent, [[1, 1], [2, 2], [3, 2]]);
});

test('NewestQuestion_WithoutAConnection_IsNotUnderWay', () => {
    let isOpen = false;
    const { questions, sent } = asking(() => isOpen);
    questions.ask({ v: 1, time: 1 });
    assert.equal(questions.isWaiting, false);
    isOpen = true;
    questions.ask({ v: 1, time: 1 });
    assert.deepEqual(sent, [[1, 1]]);
});

test('IsInScene_NotThoseOnThePicture', () => {
    assert.deepEqual(['path', 'label', 'zone', 'text', 'title', 'tip', 'plan', 'image']
        .filter((kind) => isInScene({ kind })), ['path', 'label', 'zone']);
});

function line(points: Triple[], more: Partial<ShownLine> = {}): ShownLine {
    return {
        points, strengths: points.map((_, i) => 1 - i / 10), colour: [1, 0.5, 0], edge: [0, 0, 0],
        width: 0.01, isClosed: false, hasRoundEnds: true, hasHead: false, ...more,
    };
}

/// 100 pixels a metre, from above.
const fromAbove = ([x, y]: Triple): [number, number] => [100 * x, -100 * y];

/// From, to, before, after and what each piece is.
function rows(numbers: number[]): (number | number[])[][] {
    return Array.from({ length: numbers.length / kNumbersPerPiece }, (_, i) => {
        const at = numbers.slice(i * kNumbersPerPiece, (i + 1) * kNumbersPerPiece);
        return [at.slice(0, 3), at.slice(3, 6), at.slice(6, 9), at.slice(9, 12), at.at(-1) as number];
    });
}

const kCorner: Triple[] = [[0, 0, 0], [1, 0, 0], [1, 0, 0], [1, 1, 0]];

test('LinePieces_KnowTheirNeighbours', () => {
    const numbers = linePieces([line(kCorner)], fromAbove, 600);
    const [a, , b, c] = kCorner;
    assert.deepEqual(rows(numbers), [[a, b, a, c, kJoinsAfter + kRound], [b, c, a, c, kJoinsBefore + kRound]]);
    // The opacity of the second point of one place counts for neither end.
    assert.deepEqual(numbers.slice(18, 21), [1, 0.9, 0.01]);
    assert.deepEqual(numbers.slice(kNumbersPerPiece + 12, kNumbersPerPiece + 18), [1, 0.5, 0, 0, 0, 0]);
});

test('LinePieces_OfAClosedLine_AreARing', () => {
    const [a, , b, c] = kCorner as [Triple, Triple, Triple, Triple];
    const joined = kJoinsBefore + kJoinsAfter;
    assert.deepEqual(rows(linePieces([line([a, b, c], { isClosed: true, hasRoundEnds: false })],
        fromAbove, 600)), [[a, b, c, c, joined], [b, c, a, a, joined], [c, a, b, b, joined]]);
});

test('LinePieces_OfAPoint_AreADot', () => {
    const at: Triple = [1, 2, 3];
    assert.deepEqual(rows(linePieces([line([at])], fromAbove, 600)), [[at, at, at, at, kRound]]);
});

test('LinePieces_OfAnArrow_HaveTheirEdgesBelow', () => {
    const [a, b]: Triple[] = [[0, 0, 0], [1, 0, 0]] as [Triple, Triple];
    // A width of 1 % of 600 pixels: the head has 25.2 of 100 pixels.
    const pieces = rows(linePieces([line([a, b], { hasHead: true })], fromAbove, 600));
    assert.deepEqual(pieces.map((row) => row[4]), [kEdgeOnly + kRound, kEdgeOnly + kHead,
        kCoreOnly + kRound, kCoreOnly + kHead]);
    const near = (actual: unknown, x: number) =>
        assert.ok(Math.abs((actual as number[])[0] as number - x) < 1e-9, `${actual} instead of ${x}`);
    near(pieces[1]?.[0], 1 - 0.252);
    near(pieces[1]?.[1], 1);
    near(pieces[0]?.[1], 1 - 0.75 * 0.252);
});

test('WithoutHead_OnABentLine_TheBaseIsTheHeadsLengthFromTheTip', () => {
    const points: Triple[] = [[0, 0, 0], [1, 0, 0], [1, 0.1, 0], [1, 0.2, 0]];
    const found = withoutHead(points, points.map(fromAbove), 7);
    const [x, y] = found?.base ?? [0, 0, 0];
    assert.ok(Math.abs(100 * Math.hypot(1 - x, 0.2 - y) - 4.2 * 7) < 1e-9, `${[x, y]}`);
    assert.deepEqual(found?.points.slice(0, 1), [[0, 0, 0]]);
    assert.equal(found?.points.length, 2);
});

test('WithoutHead_OfAShortLine_IsHalfOfIt', () => {
    const points: Triple[] = [[0, 0, 0], [0.1, 0, 0]];
    const found = withoutHead(points, points.map(fromAbove), 7);
    assert.ok(Math.abs((found?.base[0] ?? 0) - 0.05) < 1e-9);
    assert.equal(withoutHead([[0, 0, 0], [0, 0, 0]], [[0, 0], [0, 0]], 7), null);
});

test('LinePieces_OfAnArrowBehindTheCamera_HaveNoHead', () => {
    const pieces = rows(linePieces([line([[0, 0, 0], [1, 0, 0]], { hasHead: true })], () => null, 600));
    assert.equal(pieces.length, 1);
});

test('TrianglesOf_AnAreaThatIsNotConvex_FillIt', () => {
    // An L in the plane x = 2, of which the corner (1, 1) is not a part.
    const corners: Triple[] = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]
        .map(([y, z]) => [2, y ?? 0, z ?? 0]);
    const index = trianglesOf(corners);
    let area = 0;
    for (let i = 0; i < index.length; i += 3) {
        const [a, b, c] = index.slice(i, i + 3).map((at) => corners[at] as Triple) as [Triple, Triple, Triple];
        area += Math.abs((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])) / 2;
    }
    assert.ok(Math.abs(area - 3) < 1e-12, `${area}`);
});

function shape(more: Partial<AnnotationShape>): AnnotationShape {
    return { annotation: 0, kind: 'line', first: 0, points: 1, colour: [1, 0, 0.5], opacity: 0.5,
        width: 0.01, is_closed: false, has_round_ends: true, has_head: false, ...more };
}

test('ShownShapes_ReadTheirNumbersAndEncodeColours', () => {
    const label = { text: 'a', font: 'sans', line_height: 0.1, letters: [0.2, 0.1] as [number, number],
        margin: [0.01, 0.025] as [number, number], offset: [0, 0] as [number, number], is_above: false,
        nearer: 0, box_colour: [0, 0, 0] as Triple, box_opacity: 0.5 };
    const numbers = new Float64Array([9, 9, 9, 9, 1, 2, 3, 0.5, 4, 5, 6, 1]);
    const { areas, lines, texts } = shownShapes({ head: { q: 1, v: 1, shapes: [
        shape({ first: 4, points: 2 }), shape({ kind: 'area', first: 8, annotation: 1 }),
        shape({ kind: 'text', first: 8, annotation: 2, label }),
    ] }, numbers }, 0);
    const [halo, only] = lines;
    assert.deepEqual([only?.points, only?.strengths], [[[1, 2, 3], [4, 5, 6]], [0.25, 0.5]]);
    assert.ok(Math.abs((only?.colour[2] ?? 0) - 0.735) < 0.001, 'sRGB of 0.5');
    assert.deepEqual([lines.length, halo?.points, (halo?.width ?? 0) > 0.015], [2, only?.points, true],
        'the chosen one');
    assert.deepEqual([areas[0]?.corners, areas[0]?.opacity], [[[4, 5, 6]], 0.5]);
    assert.deepEqual([texts[0]?.at, texts[0]?.colour, texts[0]?.edge], [[4, 5, 6], 'rgb(255 0 188)', null]);
    assert.deepEqual(sizeOfText(label, 100), [22, 15]);
    assert.deepEqual(shownShapes(null, -1), { areas: [], lines: [], texts: [] });
});
