# To be sourced.

step() { echo; echo "== $*"; }

# check_port PORT: says so and ends if somebody listens there.
check_port() {
    if (: < "/dev/tcp/127.0.0.1/$1") 2>/dev/null; then
        echo "Something else listens at port $1 and would answer for a model: set PORT to a free one." >&2
        exit 1
    fi
}

# same_settings FOLDER NAME=VALUE...: steps that are done aren't done again, so a folder keeps the
# settings it was begun with; with others it ends.
same_settings() {
    local file=$1/settings asked
    asked=$(printf '%s\n' "${@:2}")
    mkdir -p "$1"
    if [ ! -e "$file" ]; then
        if [ -n "$(ls -A "$1")" ]; then
            echo "$1 has something else in it, and doesn't say its settings: set OUT to another folder." >&2
            exit 1
        fi
        echo "$asked" > "$file.new" && mv "$file.new" "$file"
    fi
    diff "$file" <(echo "$asked") >&2 || {
        echo "$1 was begun with the settings marked <: ask for these, or set OUT to another folder." >&2
        exit 1
    }
}
