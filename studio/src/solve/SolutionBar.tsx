/// What is sought, and the chosen one of the strikes that were found, over the lower edge of the view.
import { ChevronLeft, ChevronRight, LocateOff, X, type LucideIcon } from 'lucide-preact';
import { isRefining } from '../view/picture/picture_state';
import { leaveSearch, step, wishRest, writeChosen } from './search';
import { chosen, chosenIndex, found, isSearching, shownSolutions, wish } from './solve_state';
import { chanceWords, degrees, pocketWords, routeWords, speedWords, tipWords } from './solution_text';
import './solution_bar.css';

/// "Pot one in corner left back".
function title(): string {
    const one = wish.value;
    const pocket = one?.pocket ? ` in ${pocketWords(one.pocket)}` : '';
    return one ? `Pot ${one.ball}${pocket}` : '';
}

function Found() {
    const one = chosen.value;
    const message = shownSolutions.value?.head.message
        || (isSearching.value && !one ? 'Searching …' : '');
    return (
        <div class="found" role="status">
            {one ? (
                <div class="facts">
                    <b title="Of a club player's strikes so many succeed; the aim may lie anywhere within the angle">
                        {chanceWords(one)}
                    </b>
                    <span>{speedWords(one)}</span>
                    <span>{tipWords(one.tip)}</span>
                    {one.elevation > 0 ? <span>raised {degrees(one.elevation)}</span> : null}
                    <span class="route">{routeWords(one.route)}</span>
                </div>
            ) : null}
            {message ? <p>{message}</p> : null}
        </div>
    );
}

function Tool({ icon: Icon, label, hint, onClick, isDisabled = false }: {
    icon: LucideIcon; label: string; hint: string; onClick(): void; isDisabled?: boolean;
}) {
    return (
        <button type="button" class="tool" aria-label={label} title={`${label}${hint}`}
            disabled={isDisabled} onClick={onClick}>
            <Icon size={15} aria-hidden="true" />
        </button>
    );
}

export function SolutionBar() {
    const one = wish.value;
    const count = found.value.length;
    return one ? (
        <div class="solution-space">
            <div class={isRefining.value ? 'solution-bar' : 'solution-bar beside'} role="group"
                aria-label="Solutions" aria-busy={isSearching.value}>
                <div class="what">
                    <h2 title={title()}>{title()}</h2>
                    <Tool icon={ChevronLeft} label="Previous solution" hint=" (← or wheel)"
                        isDisabled={count < 2} onClick={() => step(-1)} />
                    <span class="count">{count > 0 ? `${chosenIndex.value + 1} of ${count}` : '–'}</span>
                    <Tool icon={ChevronRight} label="Next solution" hint=" (→ or wheel)"
                        isDisabled={count < 2} onClick={() => step(1)} />
                    <span class={isSearching.value ? 'busy on' : 'busy'} aria-hidden="true" />
                </div>
                <Found />
                <div class="actions">
                    {one.rest ? (
                        <Tool icon={LocateOff} label={`${one.struck} may end anywhere`} hint=""
                            onClick={() => wishRest(null)} />
                    ) : null}
                    <button type="button" class="write" disabled={chosen.value === null}
                        title="Write this strike into the text (Enter)" onClick={writeChosen}>
                        Use strike
                    </button>
                    <Tool icon={X} label="Leave the solutions" hint=" (Esc)" onClick={leaveSearch} />
                </div>
            </div>
        </div>
    ) : null;
}
