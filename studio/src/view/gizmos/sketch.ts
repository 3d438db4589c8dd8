/// Draws the figures of all gizmos, those that move with the play head apart from the others.
import { effect } from '@preact/signals';
import type { Object3D } from 'three';
import type { ViewContext } from '../parts';
import type { Figure } from './figure';
import { Labels } from './labels';
import { Layer } from './layer';

/// What browser checks see of the gizmos: `window.studio.gizmos`.
export const forTests: Record<string, unknown> = {};

const sketches = new WeakMap<Object3D, Sketch>();

/// The sketch of a view, which all its gizmos share.
export function sketchOf(context: ViewContext): Sketch {
    const sketch = sketches.get(context.scene) ?? new Sketch(context);
    sketches.set(context.scene, sketch);
    return sketch;
}

/// Figures that move with the play head are drawn apart from those that stand still, which are then
/// not built anew for each frame.
export type Pace = 'still' | 'moving';

function isEmpty(figure: Figure | undefined): boolean {
    return !figure || Object.values(figure).every((list: unknown[]) => list.length === 0);
}

export class Sketch {
    private readonly layers: Record<Pace, Layer>;
    private readonly labels: Labels;
    private readonly waiting = new Set<Layer>();
    private readonly end: () => void;

    constructor(private readonly context: ViewContext) {
        this.layers = { still: new Layer(context), moving: new Layer(context) };
        this.labels = new Labels(context);
        forTests['figure'] = (name: string) => this.figure(name);
        forTests['draws'] = (pace: Pace) => this.layers[pace].draws;
        if (window.studio) {
            window.studio['gizmos'] = forTests;
        }
        this.end = effect(() => {
            void context.moved.value;
            Object.values(this.layers).forEach((layer) => layer.placeTips());
            this.labels.place();
        });
    }

    /// Shows a figure in place of the one of the same name, which has the same pace.
    show(name: string, figure: Figure, pace: Pace = 'still'): void {
        const layer = this.layers[pace];
        const isNothingNew = isEmpty(figure) && isEmpty(layer.figures.get(name));
        layer.figures.set(name, figure);
        if (isNothingNew) {
            return;
        }
        if (this.waiting.size === 0) {
            queueMicrotask(() => this.draw());
        }
        this.waiting.add(layer);
    }

    /// What is shown under a name, for tests.
    figure(name: string): Figure {
        const layer = Object.values(this.layers).find(({ figures }) => figures.has(name));
        return layer?.figures.get(name) ?? {};
    }

    hide(name: string, pace: Pace = 'still'): void {
        this.show(name, {}, pace);
    }

    /// Ends everything. Called by each part that used it; the first call counts.
    dispose(): void {
        if (sketches.get(this.context.scene) === this) {
            sketches.delete(this.context.scene);
            this.end();
            this.labels.dispose();
            Object.values(this.layers).forEach((layer) => layer.dispose());
        }
    }

    private draw(): void {
        this.waiting.forEach((layer) => layer.draw());
        this.waiting.clear();
        this.labels.update(Object.values(this.layers).flatMap((layer) => layer.labels));
        this.context.ask();
    }
}
