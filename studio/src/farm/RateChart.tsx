/// Frames an hour over the time since the first one.
import { clockText, countText } from './farm_text';
import { rateCurve } from './frame_rate';
import type { FrameRow } from './farm_types';

const kWidth = 480;
const kHeight = 120;

export function RateChart({ rows }: { rows: FrameRow[] }) {
    const curve = rateCurve(rows);
    if (!curve) {
        return <p class="nothing">The curve begins with the second frame.</p>;
    }
    const step = kWidth / curve.rates.length;
    const y = (rate: number) => kHeight * (1 - rate / curve.most);
    const line = curve.rates.map((rate, i) => `H${(i * step).toFixed(1)}V${y(rate).toFixed(1)}H${((i + 1) * step).toFixed(1)}`).join('');
    const mean = countText(curve.rates.reduce((sum, rate) => sum + rate, 0) / curve.rates.length);
    const withDay = curve.to - curve.from > 86400;
    return (
        <figure class="rate">
            <div class="plot">
                <span class="most">{countText(curve.most)}</span>
                <span class="none">0</span>
                <svg viewBox={`0 0 ${kWidth} ${kHeight}`} preserveAspectRatio="none" role="img"
                    aria-label={`Frames an hour: ${mean} on average, at most ${countText(Math.max(...curve.rates))}`}>
                    <path class="grid" d={`M0 0H${kWidth}M0 ${kHeight / 2}H${kWidth}M0 ${kHeight}H${kWidth}`} />
                    <path class="area" d={`M0 ${kHeight}${line}V${kHeight}Z`} />
                    <path class="line" d={`M0 ${y(curve.rates[0] ?? 0)}${line}`} />
                </svg>
            </div>
            <figcaption>
                <span>{clockText(curve.from, withDay)}</span>
                <span>{mean} an hour on average</span>
                <span>{clockText(curve.to, withDay)}</span>
            </figcaption>
        </figure>
    );
}
