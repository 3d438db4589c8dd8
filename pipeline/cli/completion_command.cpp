#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

namespace {

// The program itself knows the completions (completion.h): each script passes the words to it and
// shows its output. Shells pass the words as they were typed, so the scripts remove quotes and
// expand "~/", with which the path of a shot may begin.

constexpr const char* kBash = R"script(# bash completion for carom; made by 'carom completion bash'.
_carom() {
    # bash splits words at "=" and ":". Parts without a blank between them are joined again.
    local line=$COMP_LINE part words=() offers prefix ending
    for part in "${COMP_WORDS[@]:0:COMP_CWORD+1}"; do
        if [[ ${#words[@]} -gt 0 && $line != [[:space:]]* ]]; then
            words[-1]+=$part
        else
            words+=("$part")
        fi
        line=${line#*"$part"}
    done
    words=("${words[@]//[\"\'\\]/}")
    words=("${words[@]/#~\//$HOME/}")
    local cur=${COMP_WORDS[COMP_CWORD]//[\"\'\\]/}
    [[ $cur == [=:]* ]] && cur=
    prefix=${words[-1]%"$cur"}
    mapfile -t offers < <("${words[0]}" __complete "${words[@]:1}" 2>/dev/null)
    case ${offers[0]-} in
        :folders) mapfile -t COMPREPLY < <(compgen -d -- "$cur") ;;
        :files) mapfile -t COMPREPLY < <(compgen -f -- "$cur") ;;
        :files*) mapfile -t COMPREPLY < <(compgen -d -- "$cur" || :
            for ending in ${offers[0]#:files}; do
                compgen -f -X "!*.$ending" -- "$cur" || :
            done) ;;
        *) COMPREPLY=("${offers[@]%%$'\t'*}")
            COMPREPLY=("${COMPREPLY[@]#"$prefix"}") ;;
    esac
    if [[ ${offers[0]-} == :* ]]; then
        compopt -o filenames 2>/dev/null || :
    elif [[ ${COMPREPLY[0]-} == *[.=] ]]; then
        compopt -o nospace 2>/dev/null || :
    fi
    return 0
}
complete -F _carom carom
)script";

constexpr const char* kZsh = R"script(#compdef carom
# zsh completion for carom; made by 'carom completion zsh'.
_carom() {
    local -a asked=("${(@Q)words[1,CURRENT]}") offers texts shown space
    asked=("${(@)asked/#\~\//$HOME/}")
    offers=("${(@f)$($asked[1] __complete "${(@)asked[2,-1]}" 2>/dev/null)}")
    [[ $offers[1] == :* ]] && compset -P '--*='
    case $offers[1] in
        '') return 1 ;;
        :folders) _files -/ ;;
        :files) _files ;;
        :files*) _files -g "*.(${(j:|:)${=offers[1]#:files }})" ;;
        *)  texts=("${(@)offers%%$'\t'*}")
            shown=("${(@)offers/$'\t'/  -- }")
            [[ $texts[1] == *[.=] ]] && space=(-S '')
            compadd "${(@)space}" -l -d shown -- "${(@)texts}" ;;
    esac
}
if [ "$funcstack[1]" = _carom ]; then _carom "$@"; else compdef _carom carom; fi
)script";

constexpr const char* kFish = R"script(# fish completion for carom; made by 'carom completion fish'.
function __carom_offers
    set -l words (commandline -opc) "$(commandline -ct)"
    set words (string replace -r '^~/' "$HOME/" -- $words)
    set -l offers ($words[1] __complete $words[2..-1] 2>/dev/null)
    # Files for "--output=FILE" are searched without the prefix "--output=".
    string match -rq -- '^(?<prefix>--[^=]+=)?(?<typed>.*)$' "$(commandline -ct)"
    switch "$offers[1]"
        case ':folders'
            printf '%s\n' "$prefix"(__fish_complete_directories "$typed")
        case ':files'
            printf '%s\n' "$prefix"(__fish_complete_path "$typed")
        case ':files *'
            set -l endings (string join '|' (string split ' ' -- $offers[1])[2..-1])
            printf '%s\n' "$prefix"(__fish_complete_path "$typed" |
                string match -r '^.*(?:/|\.(?:'$endings'))(?:\t.*)?$')
        case '*'
            printf '%s\n' $offers
    end
end
complete -c carom -f -a '(__carom_offers)'
)script";

const char* script_of(const std::string& shell) {
    if (shell == "bash") {
        return kBash;
    }
    return shell == "zsh" ? kZsh : kFish;
}

}  // namespace

void run(const CompletionCommand& command, CommandContext& /*context*/) {
    check_output_folder(command.output);
    write_text_output(command.output.empty() ? "-" : command.output, script_of(command.shell));
}

}  // namespace carom::cli
