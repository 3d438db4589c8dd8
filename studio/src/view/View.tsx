/// The three-dimensional view, or the plan where the browser cannot draw it. Fills its parent, which
/// needs a size.
import type { RefObject } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { FlatView } from './flat/FlatView';
import { SolutionBar } from '../solve/SolutionBar';
import { Menu } from './menu/Menu';
import { PictureBar } from './picture/PictureBar';
import { Stage } from './stage';
import { ViewToolbar } from './toolbar/ViewToolbar';

const kPatience = 5000; // ms until a lost context is taken as gone for good

/// Calls `gone` if the browser takes WebGL away and does not give it back. Returns a function that ends
/// this.
function watchContext(canvas: HTMLCanvasElement, gone: () => void): () => void {
    let timer = 0;
    const lost = () => { timer = window.setTimeout(gone, kPatience); };
    const restored = () => clearTimeout(timer);
    canvas.addEventListener('webglcontextlost', lost);
    canvas.addEventListener('webglcontextrestored', restored);
    return () => {
        restored();
        canvas.removeEventListener('webglcontextlost', lost);
        canvas.removeEventListener('webglcontextrestored', restored);
    };
}

/// The stage on the canvas, as long as that is there. `gone` is called if it cannot be.
function useStage(canvas: RefObject<HTMLCanvasElement>, gone: () => void): void {
    useEffect(() => {
        const element = canvas.current;
        const parent = element?.parentElement;
        const stage = element && Stage.on(element);
        if (!stage || !parent) {
            gone();
            return undefined;
        }
        const watcher = new ResizeObserver(() =>
            stage.resize(parent.clientWidth, parent.clientHeight));
        watcher.observe(parent);
        const forget = watchContext(element, gone);
        if (window.studio) {
            window.studio['view'] = stage;
        }
        return () => {
            forget();
            watcher.disconnect();
            stage.dispose();
        };
    }, []);
}

function DrawnView({ gone }: { gone: () => void }) {
    const canvas = useRef<HTMLCanvasElement>(null);
    useStage(canvas, gone);
    return (
        <>
            <canvas
                ref={canvas} tabIndex={0} role="img" aria-label="The scene"
                style={{ display: 'block', width: '100%', height: '100%' }}
            />
            <ViewToolbar />
        </>
    );
}

export function View() {
    const [isPossible, setPossible] = useState(true);
    return (
        <div
            class="view"
            style={{ position: 'relative', width: '100%', height: '100%', overflow: 'hidden' }}
        >
            {isPossible ? <DrawnView gone={() => setPossible(false)} /> : <FlatView />}
            <PictureBar />
            <SolutionBar />
            <Menu />
        </div>
    );
}
