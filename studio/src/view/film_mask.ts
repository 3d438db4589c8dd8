/// Darkens what the film does not show while the view looks through a camera.
import { letterbox, type Rectangle } from './letterbox';

export class FilmMask {
    /// Fills the film's rectangle.
    readonly element = document.createElement('div');

    /// Above the canvas, below everything else that is over it.
    constructor(canvas: HTMLElement) {
        Object.assign(this.element.style, {
            position: 'absolute', pointerEvents: 'none',
            boxShadow: '0 0 0 9999px rgb(0 0 0 / 55%)',
        });
        this.element.hidden = true;
        canvas.after(this.element);
    }

    /// Puts it over a view of that size; returns the film's rectangle.
    show(view: { width: number; height: number }, aspect: number): Rectangle {
        const box = letterbox(view, aspect);
        for (const side of ['left', 'top', 'width', 'height'] as const) {
            this.element.style[side] = `${box[side]}px`;
        }
        this.element.hidden = false;
        return box;
    }

    hide(): void {
        this.element.hidden = true;
    }

    dispose(): void {
        this.element.remove();
    }
}
