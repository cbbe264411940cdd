#!/bin/sh
# The commands by which README has several machines render a picture in strips, as they stand there,
# but here and smaller: every pixel of the joined strips is that of the whole picture.
#
#   sh strips.sh SWTRACER PROJECT
set -eu
swtracer=$1
project=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

for tool in parallel convert; do
    command -v "$tool" >/dev/null || { echo "strips: skipped, as there is no $tool"; exit 77; }
done
# moreutils has a program of that name, too.
parallel --version </dev/null 2>/dev/null | grep -q GNU ||
    { echo "strips: skipped, as parallel is not GNU's"; exit 77; }

# The code in README's section that begins with a line, for 16 strips of 4 rows.
code() {
    sed -n '/^## More than one machine/,/^## Teach/s/^    //p' "$project/README.md" |
        awk -v first="$1" 'index($0, first) == 1 { on = 1 }
            on { print } on && !/\\$/ && !/^(#|rows=|top=)/ { exit }' |
        sed -e 's/8192/64/g' -e 's/7680/60/g' -e 's/512/4/g' -e 's/-S [^ ]* --workdir \./-j 4/' \
            -e "s|build/swtracer|'$swtracer'|" -e "s|big\.nff|'$project/scenes/glass.nff'|"
}

# Compares what ImageMagick's command in README makes of the strips.
join() {
    join=$(sed -n 's/.*`\(convert [^`]*-append [^`]*\)`.*/\1/p' "$project/README.md")
    [ "$(ls strip-*.png | wc -l)" = 16 ] || { echo "$1: expected 16 strips, found:" strip-*; exit 1; }
    sh -euc "$join"
    convert big.png rgb:found
    cmp whole found || { echo "$1: expected the whole picture's pixels"; exit 1; }
    rm strip-*.png big.png
    echo "$1: the same $(wc -c <found) bytes of pixels"
}

"$swtracer" "$project/scenes/glass.nff" --size 64x64 --quiet -o whole.png
convert whole.png rgb:whole
[ "$(wc -c <whole)" = $((3 * 64 * 64)) ] || { echo "expected 64x64 pixels"; exit 1; }

code parallel >parallel.sh
sh -eu ./parallel.sh </dev/null
join parallel

code '#!/bin/sh' >strips.sh
grep -q '^#SBATCH --array=0-15$' strips.sh
SLURM_CPUS_PER_TASK=$(sed -n 's/^#SBATCH --cpus-per-task=//p' strips.sh)
export SLURM_CPUS_PER_TASK
seq 0 15 | parallel -j 4 SLURM_ARRAY_TASK_ID={} sh -eu ./strips.sh
join 'array job'
