/// Short texts at places of the scene, as elements over the canvas.
import type { ViewContext } from '../parts';
import type { Label } from './figure';
import './gizmos.css';

const kBeside = 16; // CSS pixels, of a label from its place and from the edge

export class Labels {
    private readonly parent = document.createElement('div');
    private labels: readonly Label[] = [];
    private widths: number[] = [];

    constructor(private readonly context: ViewContext) {
        this.parent.className = 'gizmo-labels';
        context.canvas.parentElement?.append(this.parent);
    }

    update(labels: readonly Label[]): void {
        this.labels = labels;
        while (this.parent.children.length > labels.length) {
            this.parent.lastElementChild?.remove();
        }
        labels.forEach((label, i) => {
            const element = this.parent.children[i] ?? this.parent.appendChild(
                document.createElement('span'));
            element.textContent = label.text;
            element.className = `${label.tone ?? 'plain'}${label.isBelow ? ' below' : ''}`;
            (element as HTMLElement).hidden = false;
        });
        this.widths = [...this.parent.children].map((one) => (one as HTMLElement).offsetWidth);
        this.place();
    }

    /// Puts them where the camera sees their places now; one that would end beyond the view's right edge
    /// is moved to the left.
    place(): void {
        const { width } = this.context.size();
        this.labels.forEach((label, i) => {
            const element = this.parent.children[i] as HTMLElement;
            const place = this.context.toScreen(label.at);
            element.hidden = place === null;
            if (place) {
                const right = Math.max(place[0], 0) === place[0] && place[0] < width
                    ? width - (this.widths[i] ?? 0) - kBeside : Infinity;
                const x = Math.round(Math.min(place[0], Math.max(right, 0)));
                const y = Math.round(place[1]);
                element.style.transform = `translate(${x}px, ${y}px)`;
            }
        });
    }

    dispose(): void {
        this.parent.remove();
    }
}
