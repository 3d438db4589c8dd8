/// Short texts at places of the scene, as elements over the canvas.
import type { ViewContext } from '../parts';
import type { Label } from './figure';
import './gizmos.css';

export class Labels {
    private readonly parent = document.createElement('div');
    private labels: readonly Label[] = [];

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
        });
        this.place();
    }

    /// Puts them where the camera sees their places now.
    place(): void {
        this.labels.forEach((label, i) => {
            const element = this.parent.children[i] as HTMLElement;
            const place = this.context.toScreen(label.at);
            element.hidden = place === null;
            if (place) {
                const [x, y] = place.map(Math.round);
                element.style.transform = `translate(${x}px, ${y}px)`;
            }
        });
    }

    dispose(): void {
        this.parent.remove();
    }
}
