typedef int empty; // until the back end has sources
