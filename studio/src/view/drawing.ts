/// The canvas of the view: draws on demand, never in an idle loop.
import type { Camera, Scene } from 'three';
import { WebGLRenderer } from 'three';
import { dragging, hasErrors, isDeferred, isStale } from '../state/state';

/// Whether pictures are made by the processor: then without antialiasing and with simple materials.
/// The address option #fast asks for it.
export function isSoftware(context: WebGLRenderingContext | WebGL2RenderingContext): boolean {
    const info = context.getExtension('WEBGL_debug_renderer_info');
    const name = info ? String(context.getParameter(info.UNMASKED_RENDERER_WEBGL)) : '';
    return /swiftshader|llvmpipe|software/i.test(name) || location.hash.includes('fast');
}

/// A renderer without antialiasing where the processor draws; null without WebGL.
function makeRenderer(canvas: HTMLCanvasElement): WebGLRenderer | null {
    try {
        const probe = document.createElement('canvas').getContext('webgl2');
        if (!probe) {
            return null;
        }
        const antialias = !isSoftware(probe);
        probe.getExtension('WEBGL_lose_context')?.loseContext();
        return new WebGLRenderer({ canvas, antialias });
    } catch {
        return null;
    }
}

const kLongestWait = 120; // ms, between two pictures of a drag

export class Drawing {
    readonly renderer: WebGLRenderer;
    readonly isFast: boolean;
    frames = 0; // drawn so far, for tests
    private asked = 0;
    private drawn = 0; // when, ms

    private constructor(
        renderer: WebGLRenderer, private readonly scene: Scene,
        private readonly camera: () => Camera,
    ) {
        this.renderer = renderer;
        this.isFast = isSoftware(renderer.getContext());
        // three restores its objects by itself; what was shown has to be drawn again.
        renderer.domElement.addEventListener('webglcontextrestored', () => this.ask());
    }

    /// Null if the browser has no WebGL.
    static on(canvas: HTMLCanvasElement, scene: Scene, camera: () => Camera): Drawing | null {
        const renderer = makeRenderer(canvas);
        return renderer && new Drawing(renderer, scene, camera);
    }

    /// Draws once at the display's next frame, however often it is called until then.
    ask(): void {
        this.asked ||= requestAnimationFrame((now) => this.draw(now));
    }

    private draw(now: number): void {
        this.asked = 0;
        if (this.mayWait(now)) {
            this.ask();
            return;
        }
        this.drawn = now;
        this.renderer.render(this.scene, this.camera());
        this.frames += 1;
    }

    /// Whether the new motion of a dragged body is about to come. Where the processor draws, a
    /// picture without it would only delay the one with it.
    private mayWait(now: number): boolean {
        return this.isFast && dragging.peek() && isStale.peek() && !hasErrors.peek()
            && !isDeferred.peek() && now - this.drawn < kLongestWait;
    }

    /// Sizes in CSS pixels.
    resize(width: number, height: number): void {
        this.renderer.setPixelRatio(this.isFast ? 1 : Math.min(devicePixelRatio, 2));
        this.renderer.setSize(width, height, false);
        this.ask();
    }

    dispose(): void {
        cancelAnimationFrame(this.asked);
        this.renderer.dispose();
    }
}
