/// Annotations on the picture, while the view looks through a camera: their frames, which are dragged.
/// What is in them is written there until the picture is traced, which has it itself.
import { computed, effect, signal } from '@preact/signals';
import { cameraLookedThrough } from '../motion/clock';
import { annotationName, withoutValues } from '../outline/annotation_name';
import type { KeyPath } from '../protocol';
import { filmTime, hovered, sceneTime, selection, shot } from '../state/state';
import { annotationAt, isDrawnAt, movedCentre, onPicture, type PictureAnnotation } from './annotation_boxes';
import { editDrag } from './gizmos/dragging';
import { forTests } from './gizmos/sketch';
import { kGizmoPriority, type MakePart, type Pixel, type ViewContext } from './parts';
import { channel, shownFrame, shownPicture } from './picture/picture_state';
import './annotations.css';

const kLineShare = 0.74; // of a line's height that its letters have
const kLetter = 0.6; // width of a letter on average, font sizes
const kName = 12; // px

/// Where one is during a drag.
const dragged = signal<{ path: string; centre: [number, number] } | null>(null);

function isAt(path: KeyPath | null, { path: own }: PictureAnnotation): boolean {
    return path !== null && own.every((key, i) => path[i] === key);
}

/// Those that are drawn at the play head, and the selected one; none in the free view.
const shown = computed<PictureAnnotation[]>(() => {
    if (cameraLookedThrough.value < 0) {
        return [];
    }
    const moved = dragged.value;
    return onPicture(shot.value?.annotations ?? [])
        .filter((one) => isAt(selection.value, one) || isDrawnAt(one, filmTime.value, sceneTime.value))
        .map((one) => moved?.path === one.path.join('/')
            ? { ...one, box: { ...one.box, centre: moved.centre } } : one);
});

/// Whether the picture has them drawn.
const isTraced = computed(() =>
    shownPicture.value !== null && shownFrame.value !== null && channel.value === '');

/// What stands in a box of that size (px), and the size of its letters.
function contentOf(one: PictureAnnotation, width: number, height: number) {
    const isName = one.text === '';
    const text = isName ? annotationName(one) : withoutValues(one.text).trimEnd();
    const lines = text.split('\n');
    const longest = Math.max(...lines.map((line) => line.length), 1);
    const fitting = Math.min((kLineShare * height) / lines.length, width / (kLetter * longest));
    return { text, size: isName ? Math.min(kName, fitting) : fitting };
}

/// A place as fractions of the film's picture.
function fractions(context: ViewContext, pixel: Pixel): [number, number] {
    const canvas = context.canvas.getBoundingClientRect();
    const box = context.box();
    return [(pixel.clientX - canvas.left - box.left) / box.width,
        (pixel.clientY - canvas.top - box.top) / box.height];
}

class Frames {
    private readonly parent = document.createElement('div');

    constructor(private readonly context: ViewContext) {
        this.parent.className = 'annotation-frames';
        // Above the mask of the film, below the controls of the view.
        (context.canvas.nextElementSibling ?? context.canvas).after(this.parent);
    }

    update(all: readonly PictureAnnotation[], isFilled: boolean): void {
        while (this.parent.children.length > all.length) {
            this.parent.lastElementChild?.remove();
        }
        const { left, top, width, height } = this.context.box();
        all.forEach((one, i) => {
            const element = (this.parent.children[i] ?? this.parent.appendChild(
                document.createElement('div'))) as HTMLElement;
            const { centre, size } = one.box;
            const [wide, high] = [size[0] * width, size[1] * height];
            const content = contentOf(one, wide, high);
            element.className = ['frame', one.kind, isAt(selection.value, one) ? 'chosen' : '',
                isAt(hovered.value, one) ? 'hot' : ''].join(' ');
            element.textContent = isFilled ? content.text : '';
            Object.assign(element.style, {
                left: `${left + (centre[0] - size[0] / 2) * width}px`,
                top: `${top + (centre[1] - size[1] / 2) * height}px`,
                width: `${wide}px`, height: `${high}px`, fontSize: `${content.size}px`,
            });
        });
    }

    dispose(): void {
        this.parent.remove();
    }
}

export const makeAnnotations: MakePart = (context) => {
    const frames = new Frames(context);
    forTests['annotations'] = () => shown.peek();
    const end = effect(() => {
        void context.moved.value;
        frames.update(shown.value, !isTraced.value);
    });
    const at = (pixel: Pixel) => annotationAt(shown.peek(), ...fractions(context, pixel));
    let pointed = false;
    const point = (one: PictureAnnotation | undefined) => {
        if (one || pointed) {
            hovered.value = one?.path ?? null;
        }
        pointed = one !== undefined;
    };
    return {
        priority: kGizmoPriority,
        grab: (start) => {
            const one = at(start);
            if (!one) {
                return null;
            }
            selection.value = one.path;
            const from = fractions(context, start);
            return editDrag(start, {
                label: `Move ${annotationName(one)}`,
                changes: (event) => {
                    const to = fractions(context, event);
                    const centre = movedCentre(one.box, to[0] - from[0], to[1] - from[1]);
                    dragged.value = { path: one.path.join('/'), centre };
                    return [{ path: [...one.path, 'position'], value: centre, precision: 0.001 }];
                },
                ended: () => { dragged.value = null; },
            });
        },
        hover: (event) => {
            const one = at(event);
            point(one);
            return one ? 'grab' : null;
        },
        pick: (pixel) => at(pixel)?.path ?? null,
        dispose: () => {
            end();
            frames.dispose();
        },
    };
};
