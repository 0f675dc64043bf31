# The run time claims no names in a user's program but lsys_*, and main where the program brings none.
archive=$(dirname "$(dirname "$(command -v lsysc)")")/lib/lsysc/liblsysrt.a
nm -g --defined-only "$archive" | awk 'NF == 3 && $3 !~ /^lsys_/ { print $3 }'
