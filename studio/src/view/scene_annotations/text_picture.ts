/// Texts of annotations as pictures: letters with dark edges, or in a box.
import type { AnnotationLabel } from '../../protocol';

export interface ShownText {
    label: AnnotationLabel;
    colour: string; // of CSS, as the others
    boxColour: string;
    edge: string | null; // of one that stands out
}

// Of a line's height (pipeline/picture/text_drawing.cpp, font.cpp).
const kEm = 0.8;
const kRound = 0.25;

const kEdgeColour = '#0d1013d9'; // of letters without a box

/// The fonts of annotations by their names (pipeline/picture/fonts.cpp), and what a browser has
/// instead on a machine without them.
const kFonts: Record<string, string> = {
    sans_bold: 'bold SIZE "DejaVu Sans", Verdana, sans-serif',
    sans: 'SIZE "DejaVu Sans", Verdana, sans-serif',
    serif: 'SIZE "DejaVu Serif", Georgia, serif',
    serif_bold: 'bold SIZE "DejaVu Serif", Georgia, serif',
    mono: 'SIZE "DejaVu Sans Mono", monospace',
    mono_bold: 'bold SIZE "DejaVu Sans Mono", monospace',
};

function fontOf(name: string, size: number): string {
    return (kFonts[name] ?? 'bold SIZE sans-serif').replace('SIZE', `${size}px`);
}

/// The size of its picture, for a film's picture of that height; both in pixels.
export function sizeOfText({ letters, margin }: AnnotationLabel, height: number): [number, number] {
    const whole = (share: number) => Math.ceil(share * height - 1e-6);
    return [whole(letters[0] + 2 * margin[0]), whole(letters[1] + 2 * margin[1])];
}

function drawBox(
    pen: CanvasRenderingContext2D, { label, boxColour, edge }: ShownText, height: number,
): void {
    const line = edge === null ? 0 : Math.max(1, 0.08 * label.line_height * height);
    pen.beginPath();
    pen.roundRect(line / 2, line / 2, pen.canvas.width - line, pen.canvas.height - line,
        kRound * label.line_height * height);
    pen.globalAlpha = label.box_opacity;
    pen.fillStyle = boxColour;
    pen.fill();
    pen.globalAlpha = 1;
    if (edge !== null) {
        pen.strokeStyle = edge;
        pen.lineWidth = line;
        pen.stroke();
    }
}

/// Draws the text on a canvas of its size. Lines are as wide as those of the film, whatever font the
/// browser has.
export function drawText(canvas: HTMLCanvasElement, text: ShownText, height: number): void {
    const { label } = text;
    [canvas.width, canvas.height] = sizeOfText(label, height);
    const pen = canvas.getContext('2d');
    if (!pen) {
        return;
    }
    const hasBox = label.box_opacity > 0;
    if (hasBox) {
        drawBox(pen, text, height);
    }
    const lines = label.text.split('\n');
    pen.font = fontOf(label.font, kEm * label.line_height * height);
    pen.textAlign = 'center';
    pen.lineJoin = 'round';
    pen.lineWidth = 2 * label.margin[0] * height;
    const measures = lines.map((line) => pen.measureText(line));
    const widest = Math.max(...measures.map(({ width }) => width), 1e-6);
    const step = (label.letters[1] * height) / lines.length;
    pen.translate(canvas.width / 2, label.margin[1] * height);
    pen.scale((label.letters[0] * height) / widest, 1);
    lines.forEach((line, i) => {
        const up = measures[i]?.fontBoundingBoxAscent ?? step;
        const down = measures[i]?.fontBoundingBoxDescent ?? 0;
        const y = i * step + (step - up - down) / 2 + up;
        if (!hasBox) {
            pen.strokeStyle = text.edge ?? kEdgeColour;
            pen.strokeText(line, 0, y);
        }
        pen.fillStyle = text.colour;
        pen.fillText(line, 0, y);
    });
}
