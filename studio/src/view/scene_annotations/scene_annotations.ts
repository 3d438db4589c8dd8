/// The annotations in the scene, as the film has them: the server tells what they look like at the play
/// head. Areas lie below lines, and texts above. The path-traced picture has them itself.
import { computed, effect } from '@preact/signals';
import { Object3D } from 'three';
import { onMessage } from '../../connection/receive';
import { send } from '../../connection/socket';
import { connection, dragging, sceneAnnotations, selection } from '../../state/state';
import { showAnnotations } from '../../state/view_state';
import { forTests } from '../gizmos/sketch';
import { kDrawingPriority, type MakePart } from '../parts';
import { isPictureOld } from '../picture/asking';
import { shownPicture } from '../picture/picture_state';
import { Areas } from './areas';
import { linePieces } from './line_pieces';
import { Lines } from './lines';
import { NewestQuestion } from './newest_question';
import { questionNow, type Question } from './question';
import { shownShapes } from './shown_shapes';
import { Texts } from './texts';
import { sharedUniforms } from './uniforms';

const kOrder = 1; // of drawing: after the paths of the balls, before handles

const isTraced = computed(() =>
    shownPicture.value !== null && !dragging.value && !isPictureOld());

/// The index of the selected annotation; -1: none is.
const chosen = computed(() => {
    const [section, index] = selection.value ?? [];
    return section === 'annotations' ? Number(index) : -1;
});

export const makeSceneAnnotations: MakePart = (context) => {
    const uniforms = sharedUniforms();
    const group = new Object3D(); // a Group would have an order of its own
    const areas = new Areas(uniforms);
    const lines = new Lines(uniforms);
    const texts = new Texts(group, kOrder + 2, uniforms);
    areas.mesh.renderOrder = kOrder;
    lines.mesh.renderOrder = kOrder + 1;
    group.add(areas.mesh, lines.mesh);
    context.scene.add(group);
    const questions = new NewestQuestion<Question>((q, question) =>
        send('see_annotations', { q, ...question }));
    let wanted: Question | null = null;
    let isToAsk = false;
    /// Once for all that changes together: time, and the camera that follows it.
    const askSoon = () => {
        if (!isToAsk) {
            isToAsk = true;
            queueMicrotask(() => {
                isToAsk = false;
                questions.ask(wanted);
            });
        }
    };
    const height = computed(() => { // of the picture, CSS pixels
        void context.moved.value;
        return context.box().height;
    });
    forTests['sceneAnnotations'] = () => ({
        isShown: group.visible, isWaiting: questions.isWaiting, asked: questions.count,
        q: sceneAnnotations.peek()?.head.q ?? 0, v: sceneAnnotations.peek()?.head.v ?? 0,
        shapes: sceneAnnotations.peek()?.head.shapes ?? [], pieces: lines.count,
    });
    const ends = [
        effect(() => {
            if (connection.value !== 'open') {
                questions.forget();
            }
            const isWanted = showAnnotations.value && !isTraced.value;
            wanted = isWanted ? questionNow(context) : null;
            askSoon();
            group.visible = wanted !== null;
            if (!wanted) {
                sceneAnnotations.value = null; // another time may be shown next
            }
        }),
        effect(() => {
            const answer = sceneAnnotations.value;
            if (answer) {
                questions.answered(answer.head.q);
            }
        }),
        onMessage('failed', ({ what }) => {
            if (what === 'see_annotations') {
                questions.failed();
            }
        }),
        effect(() => {
            void context.moved.value;
            const { width, height: high } = context.size();
            const ratio = context.pixelRatio();
            uniforms.size.value.set(Math.floor(width * ratio), Math.floor(high * ratio));
        }),
        effect(() => {
            const shown = shownShapes(sceneAnnotations.value, chosen.value);
            uniforms.height.value = height.value * context.pixelRatio();
            areas.update(shown.areas);
            lines.update(linePieces(shown.lines, context.toScreen, height.value));
            texts.update(shown.texts);
            context.ask();
        }),
    ];
    return {
        priority: kDrawingPriority,
        dispose: () => {
            ends.forEach((end) => end());
            group.removeFromParent();
            areas.dispose();
            lines.dispose();
            texts.dispose();
        },
    };
};
