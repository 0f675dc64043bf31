# The page of tables is what docs/tables prints.
cd "$CASES/../../.." || exit 1
docs/tables "$(command -v lsysc)" | diff - docs/TABLES.md && echo 'up to date' || echo 'run docs/tables > docs/TABLES.md'
